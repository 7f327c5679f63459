// What thin panes leave of a light's colour on its way to the first opaque surface.
#include "passes/shared/sky_model.glsl"
#include "passes/shared/light_cone.glsl"
#include "passes/shared/light.glsl"
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/shared/pane_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
TEXTURE(1, shadow_depth)
#include "passes/shared/pane_surface.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, pane_transmittance)
#include "passes/shared/outside_tile.glsl"

// Is an opaque surface nearer to the light? Two of its map's texels' extents may lie between.
Bool in_shadow() {
  Vec3 at = view_coordinates(u.shadow_view, surface_position);
  Vec2 uv = view_uv(u.shadow_view, at);
  Vec3 q = in_face(u.shadow_view, at, view_face(u.shadow_view, at));
  Float extent = view_w(u.shadow_view, at) / (u.shadow_view.scale.x * float(texture_width(shadow_depth)));
  Float stored = fetch_nearest(shadow_depth, uv.x, uv.y).x;
  return u.has_shadow_map != 0 && inside_unit(uv.x, uv.y) && stored < q.z - 2.0f * extent;
}

void main() {
  discard_if(outside_tile(u.view, u.map_side) || cut_out(u.alpha_mask, surface_uv) || in_shadow());
  pane_transmittance = Vec4(let_through(ray_direction()), Float(1.0f));
}
#endif
