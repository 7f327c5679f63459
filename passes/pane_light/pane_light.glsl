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
TEXTURE(2, caster_position)
TEXTURE(3, transmission_texture)
#include "passes/shared/pane_surface.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, pane_transmittance)
#include "passes/shared/outside_tile.glsl"
#include "passes/shared/position_texel.glsl"

// Is an opaque surface nearer to the light? Two of its map's texels' extents may lie between.
Bool in_shadow() {
  Vec3 at = view_coordinates(u.shadow_view, surface_position);
  Vec2 uv = view_uv(u.shadow_view, at);
  Vec3 q = in_face(u.shadow_view, at, view_face(u.shadow_view, at));
  Float extent = view_w(u.shadow_view, at) / (u.shadow_view.scale.x * float(texture_width(shadow_depth)));
  Float stored = fetch_nearest(shadow_depth, uv.x, uv.y).x;
  return u.has_shadow_map != 0 && inside_unit(uv.x, uv.y) && stored < q.z - 2.0f * extent;
}

// Is there no caster behind it, on the grid vertex that is drawn?
Bool not_before_casters() {
  // One texel of zeros where the light throws no caustic.
  Vec4 caster = fetch_clamped(caster_position, floor_to_int(frag_x()), floor_to_int(frag_y()));
  Int face = Int(u.view.face);
  Float z = in_face(u.view, view_coordinates(u.view, surface_position), face).z;
  return !is_covered(caster) || z >= in_face(u.view, view_coordinates(u.view, Vec3(caster)), face).z;
}

void main() {
  Bool left_out = outside_tile(u.view, u.map_side) || not_drawn();
  if (u.before_casters != 0) {
    left_out = left_out || not_before_casters();
  } else {
    left_out = left_out || in_shadow();
  }
  discard_if(left_out);
  pane_transmittance = Vec4(1.0f);
  if (any_lane(!left_out)) pane_transmittance = Vec4(let_through(ray_direction(), Bool(false)), Float(1.0f));
}
#endif
