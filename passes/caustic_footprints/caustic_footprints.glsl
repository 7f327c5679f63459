// Adds the light that no cell has taken: each landing as the parallelogram that its own differential gives
// it. caustic_footprints.md explains.
UNIFORMS_BEGIN
#include "passes/caustic_footprints/caustic_footprints_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, landing)
TEXTURE(1, landing_flux)
TEXTURE(2, landing_footprint)
TEXTURE(3, cell_flux)
#include "passes/caustic_cells/rectangle_around.glsl"

#ifdef VERTEX_STAGE
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/landing_status.glsl"
#include "passes/shared/quarters_left.glsl"
#include "passes/shared/view_space.glsl"

// Moves a place that lies near the edge of a map that has all light to half a texel from it; others stay.
Float off_edge(Float middle) {
  Float side = Float(float(u.map_side));
  Bool on_map = u.is_part == 0 && middle >= 0.0f && middle <= side;
  return sel(on_map, clamp_to(middle, Float(0.5f), side - 0.5f), middle);
}

// A footprint's half extents in texels, no larger than it may be, nor than a map that has all light has room
// around its middle: no light is laid beyond it.
Float fitted(Float half_extent, Float middle) {
  Float side = Float(float(u.map_side));
  Float inside = max_of(min_of(middle, side - middle) - 0.25f, 0.0f);
  Bool on_map = u.is_part == 0 && middle >= 0.0f && middle <= side;
  Float most = min_of(Float(0.5f * u.largest), sel(on_map, inside, Float(0.5f * u.largest)));
  Bool finite = half_extent < 1.0e9f;
  return sel(finite, min_of(most / max_of(half_extent, most + 1.0e-6f), Float(1.0f)), Float(0.0f));
}

struct Footprint {
  Vec2 middle;  // texels
  Vec2 x;       // half a step along the grid's rows, and along its columns
  Vec2 y;
};

// At least half a texel long and wide: the shares of slivers in texels are not sharp.
void thicken(INOUT(Footprint) print) {
  Bool x_longer = dot2(print.x, print.x) >= dot2(print.y, print.y);
  Vec2 along = sel(x_longer, print.x, print.y);
  Vec2 beside = sel(x_longer, print.y, print.x);
  Float length = sqrt(dot2(along, along));
  Bool is_long = length > 0.25f;
  Vec2 unit = sel(is_long, along / sel(is_long, length, Float(1.0f)), Vec2(Float(1.0f), Float(0.0f)));
  Vec2 across = Vec2(-unit.y, unit.x);
  Bool is_wide = is_long && abs(dot2(beside, across)) > 0.25f;
  print.x = sel(is_long, along, unit * 0.25f);
  print.y = sel(is_wide, beside, across * 0.25f);
}

Footprint footprint_of(Vec4 place, Vec4 steps) {
  Vec2 uv = view_uv(u.map, view_coordinates(u.map, Vec3(place)));
  Footprint print;
  print.middle = Vec2(uv.x * u.scale.x + u.offset.x, uv.y * u.scale.y + u.offset.y);
  Vec2 x = Vec2(steps.x * (0.5f * u.scale.x), steps.y * (0.5f * u.scale.y));
  Vec2 y = Vec2(steps.z * (0.5f * u.scale.x), steps.w * (0.5f * u.scale.y));
  print.middle = Vec2(off_edge(print.middle.x), off_edge(print.middle.y));
  Float fit_x = fitted(abs(x.x) + abs(y.x), print.middle.x);
  Float fit = min_of(fit_x, fitted(abs(x.y) + abs(y.y), print.middle.y));
  Bool sized = fit > 0.0f;
  Vec2 none = Vec2(Float(0.0f), Float(0.0f));
  print.x = sel(sized, x * fit, none);
  print.y = sel(sized, y * fit, none);
  thicken(print);
  return print;
}

void main() {
  Int id = rectangle_id();
  Int row = id / Int(u.grid_side);
  Int column = id - row * Int(u.grid_side);
  Vec4 place = texel_fetch(landing, column, row);
  Vec4 carried = texel_fetch(landing_flux, column, row);
  Float part = quarters_left(column, row) * 0.25f;
  Footprint print = footprint_of(place, texel_fetch(landing_footprint, column, row));
  Vec2 a = print.middle - print.x - print.y;
  Vec2 b = print.middle + print.x - print.y;
  Vec2 c = print.middle - print.x + print.y;
  Vec2 d = print.middle + print.x + print.y;
  flux = Vec3(carried) * part;
  lay_quad(Vec4(a.x, a.y, b.x, b.y), Vec4(c.x, c.y, d.x, d.y), Float(float(u.map_side)),
           has_status(place, STATUS_LANDED) && part > 0.0f);
}
#else
#include "passes/caustic_cells/overlap.glsl"
#endif
