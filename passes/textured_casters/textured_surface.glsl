// A caster with textures drawn into a frame: vertex stage, and its outward normal. Expects the textures base_color
// and normal_texture and the uniforms of textured_casters_uniforms.glsl.
VARYING_SMOOTH(0, Vec3, surface_position)
VARYING_SMOOTH(3, Vec3, surface_normal)
VARYING_SMOOTH(6, Vec4, surface_tangent)
VARYING_SMOOTH(10, Vec2, color_uv)
VARYING_SMOOTH(12, Vec2, normal_uv)
VARYING_SMOOTH(14, Vec2, transmission_uv)

#ifdef VERTEX_STAGE
ATTRIBUTE(0, Vec3, position)
ATTRIBUTE(3, Vec3, normal)
ATTRIBUTE(6, Vec4, tangent)
ATTRIBUTE(10, Vec2, uv)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/material.glsl"

void main() {
  surface_position = position;
  surface_normal = normal;
  surface_tangent = tangent;
  // Linear in what is interpolated, so they belong to this stage (SUBSET.md).
  color_uv = transformed_uv(u.uv_row0, u.uv_row1, uv);
  normal_uv = transformed_uv(u.normal_row0, u.normal_row1, uv);
  transmission_uv = transformed_uv(u.transmission_row0, u.transmission_row1, uv);
  set_position(view_clip(view_coordinates(u.from_scene, position), u.window, u.depth));
}
#else
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/material.glsl"
#include "passes/shared/outside_tile.glsl"
#include "passes/shared/tangent_space.glsl"

// glTF's alpha mask: is the base colour's alpha below the cutoff here? Nearest texel, repeated.
Bool cut_out_here() {
  Float opacity = Float(u.alpha.x);
  if (u.alpha.z > 0.5f) {
    Vec4 texel = fetch_nearest(base_color, color_uv.x - floor(color_uv.x), color_uv.y - floor(color_uv.y));
    opacity = opacity * texel.w;
  }
  return opacity < u.alpha.y;
}

// Of a cube view: does the fragment lie outside the tile that is drawn?
Bool elsewhere() {
  Bool outside = Bool(false);
  if (u.depth.z > 1.5f) outside = outside_tile(u.window, u.depth, u.material.z);
  return outside;
}

// The outward normal, leaned by the normal texture but never out of the hemisphere around the smooth normal:
// light enters and leaves a face through the side that was drawn.
Vec3 caster_normal_here() {
  Vec3 n = normalize_or(surface_normal, Vec3(0.0f, 1.0f, 0.0f));
  if (u.uses.y > 0.5f) {
    Vec4 texel = fetch_repeat(normal_texture, normal_uv.x, normal_uv.y);
    Vec3 local = tangent_space_normal(texel, Float(u.material.y));
    local.z = max_of(local.z, 0.01f);
    n = leaned_normal(n, surface_tangent, local);
  }
  return n;
}
#endif
