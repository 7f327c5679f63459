// What thin panes leave of a light's colour on its way to the first opaque surface.
UNIFORMS_BEGIN
#include "passes/panes/pane_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
TEXTURE(1, shadow_depth)
#include "passes/panes/pane_surface.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, pane_transmittance)
#include "passes/shared/outside_tile.glsl"

// Is an opaque surface nearer to the light? Two of its map's texels' extents may lie between.
Bool in_shadow() {
  Vec3 at = view_coordinates(u.from_scene, surface_position);
  Vec2 uv = view_uv(at, u.shadow_window, u.shadow_range);
  Vec3 q = in_face(at, view_face(at, u.shadow_range), u.shadow_range);
  Float extent = view_w(at, u.shadow_range) / (u.shadow_window.x * float(texture_width(shadow_depth)));
  Float stored = fetch_nearest(shadow_depth, uv.x, uv.y).x;
  return u.uses.y > 0.5f && inside_unit(uv.x, uv.y) && stored < q.z - 2.0f * extent;
}

void main() {
  if (u.depth.z > 1.5f) discard_if(outside_tile(u.window, u.depth, u.uses.z));
  discard_if(cut_out(surface_uv) || in_shadow());
  pane_transmittance = Vec4(let_through(ray_direction()), Float(1.0f));
}
#endif
