// How near and how far each block of a light's maps reaches. shadow_bounds.md explains.
UNIFORMS_BEGIN
#include "passes/shadow_bounds/shadow_bounds_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, shadow_depth)
TEXTURE(1, caster_position)
TEXTURE(2, pane_transmittance)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, shadow_bounds)
OUTPUT(1, Vec4, caster_bounds)
OUTPUT(2, Vec4, pane_bounds)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/position_texel.glsl"

// Of a depth where there is no surface.
#define NO_SURFACE 1.0e30f

// The first texel, along one side of a map, that a block covers any of.
Int first_texel(Int block, int side) { return block * Int(side) / Int(u.blocks); }

// No block covers more texels along a side.
int most_texels(int side) { return (side + u.blocks - 1) / u.blocks + 1; }

// A texel of the block, the last one again past its end.
Int texel_of(Int block, int k, int side) {
  Int last = (block * Int(side) + Int(side - 1)) / Int(u.blocks);
  return min_of(first_texel(block, side) + k, min_of(last, Int(side - 1)));
}

Vec4 wider(Vec4 bounds, Float value) {
  return Vec4(min_of(bounds.x, value), max_of(bounds.y, value), Float(0.0f), Float(0.0f));
}

Vec4 of_nothing() { return Vec4(Float(NO_SURFACE), Float(-NO_SURFACE), Float(0.0f), Float(0.0f)); }

Vec4 opaque_bounds(Int column, Int row) {
  Vec4 bounds = of_nothing();
  int side = texture_width(shadow_depth);
  for (int j = 0; j < most_texels(side); j++) {
    for (int i = 0; i < most_texels(side); i++) {
      bounds = wider(bounds, texel_fetch(shadow_depth, texel_of(column, i, side), texel_of(row, j, side)).x);
    }
  }
  return bounds;
}

Vec4 casters_bounds(Int column, Int row) {
  Vec4 bounds = of_nothing();
  int side = texture_width(caster_position);
  for (int j = 0; j < most_texels(side); j++) {
    for (int i = 0; i < most_texels(side); i++) {
      Vec4 caster = texel_fetch(caster_position, texel_of(column, i, side), texel_of(row, j, side));
      Float depth = view_coordinates(u.caster_view, Vec3(caster)).z;
      bounds = wider(bounds, sel(is_covered(caster), depth, Float(NO_SURFACE)));
    }
  }
  return bounds;
}

// Bilinear interpolation reaches a texel beyond the block.
Float pane_spread(Int column, Int row) {
  Vec3 least = Vec3(1.0f);
  Vec3 most = Vec3(0.0f);
  int side = texture_width(pane_transmittance);
  for (int j = -1; j <= most_texels(side); j++) {
    for (int i = -1; i <= most_texels(side); i++) {
      Int x = first_texel(column, side) + i;
      Vec3 left = Vec3(fetch_clamped(pane_transmittance, x, first_texel(row, side) + j));
      least = Vec3(min_of(least.x, left.x), min_of(least.y, left.y), min_of(least.z, left.z));
      most = Vec3(max_of(most.x, left.x), max_of(most.y, left.y), max_of(most.z, left.z));
    }
  }
  Vec3 spread = most - least;
  return max_of(max_of(spread.x, spread.y), spread.z);
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 clear = Vec4(Float(NO_SURFACE), Float(NO_SURFACE), Float(0.0f), Float(0.0f));
  shadow_bounds = clear;
  caster_bounds = clear;
  pane_bounds = Vec4(0.0f);
  if (u.has_shadow_map != 0) shadow_bounds = opaque_bounds(column, row);
  if (u.has_caustic != 0) caster_bounds = casters_bounds(column, row);
  if (u.has_panes != 0) pane_bounds = Vec4(Float(0.0f), pane_spread(column, row), Float(0.0f), Float(0.0f));
}
#endif
