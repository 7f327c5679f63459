// A caster with textures drawn into a view: vertex stage, and its outward normal. Expects the textures
// base_color and normal_texture and the uniforms of textured_casters_uniforms.glsl.
#include "passes/shared/tangent_vertex.glsl"
VARYING_SMOOTH(10, Vec2, color_uv)
VARYING_SMOOTH(12, Vec2, normal_uv)
VARYING_SMOOTH(14, Vec2, transmission_uv)

#ifdef VERTEX_STAGE
#include "passes/shared/transformed_uv.glsl"

void main() {
  place_surface();
  // Linear in what is interpolated, so they belong to this stage (SUBSET.md).
  color_uv = transformed_uv(u.mask.uv, uv);
  normal_uv = transformed_uv(u.normal_uv, uv);
  transmission_uv = transformed_uv(u.transmission_uv, uv);
}
#else
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/wrapped.glsl"
#include "passes/shared/material.glsl"
#include "passes/shared/outside_tile.glsl"
#include "passes/shared/tangent_space.glsl"

// glTF's alpha mask: is the base colour's alpha below the cutoff here? Nearest texel.
Bool cut_out_here() {
  Float opacity = Float(u.mask.opacity);
  if (u.mask.textured != 0) {
    Vec2 place = wrapped(u.mask.uv, color_uv);
    Vec4 texel = fetch_nearest(base_color, place.x, place.y);
    opacity = opacity * texel.w;
  }
  return opacity < u.mask.cutoff;
}

Bool is_not_drawn() { return outside_tile(u.view, u.map_side) || cut_out_here(); }

// The outward normal, leaned by the normal texture but never out of the hemisphere around the smooth normal:
// light enters and leaves a face through the side that was drawn.
Vec3 caster_normal_here() {
  Vec3 n = normalize_or(surface_normal, Vec3(0.0f, 1.0f, 0.0f));
  if (u.has_normal_texture != 0) {
    Vec4 texel = fetch_wrapped(normal_texture, u.normal_uv, normal_uv);
    Vec3 local = tangent_space_normal(texel, Float(u.normal_scale));
    local.z = max_of(local.z, 0.01f);
    n = leaned_normal(n, surface_tangent, local);
  }
  return n;
}
#endif
