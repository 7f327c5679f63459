// What thin panes leave of a light's colour on its way to the first opaque surface.
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/pane_light/pane_light_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
TEXTURE(1, shadow_depth)
TEXTURE(2, caster_position)
TEXTURE(3, transmission_texture)
VARYING_SMOOTH(0, Vec3, surface_position)
VARYING_SMOOTH(3, Vec3, surface_normal)
VARYING_SMOOTH(6, Vec2, surface_uv)

#ifdef VERTEX_STAGE
ATTRIBUTE(0, Vec3, position)
ATTRIBUTE(3, Vec3, normal)
ATTRIBUTE(6, Vec2, uv)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"

void main() {
  surface_position = position;
  surface_normal = normal;
  surface_uv = uv;
  set_position(view_clip(u.view, view_coordinates(u.view, position)));
}
#else
OUTPUT(0, Vec4, pane_transmittance)
#include "passes/shared/wrapped.glsl"
#include "passes/shared/alpha_mask.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/material.glsl"
#include "passes/shared/transformed_uv.glsl"
#include "passes/shared/optics.glsl"

// Direction of the view's ray through the drawn point.
Vec3 ray_direction() {
  Vec3 forward = Vec3(u.forward);
  if (u.view.kind != VIEW_PARALLEL) forward = normalize_or(surface_position - Vec3(u.eye), forward);
  return forward;
}

#include "passes/shared/pane_layer.glsl"

// Reflectance of one of the pane's two faces for a ray along d.
Float face_reflectance(Vec3 d) {
  Float cosine = abs(dot3(normalize_or(surface_normal, d), d));
  return pane_reflectance(cosine, u.ior) * u.fresnel;
}

Vec4 base_texel() {
  Vec4 texel = Vec4(1.0f);
  if (u.has_base_color != 0)
    texel = fetch_wrapped(base_color, u.base_color_uv, transformed_uv(u.base_color_uv, surface_uv));
  return texel;
}

// The share of light that passes. A blended surface keeps what it covers.
Vec3 let_through(Vec3 d) {
  Vec4 texel = base_texel();
  Vec3 passes = Vec3(1.0f - u.alpha_mask.opacity * texel.w);
  if (u.is_blended == 0) {
    PaneLayer layer = layer_here(u.alpha_mask.opacity * texel.w);
    passes = pane_passes(layer, Vec3(u.color) * Vec3(texel), face_reflectance(d));
  }
  return passes;
}

// Holes, or what of a blended surface is opaque.
Bool not_drawn() {
  Bool cut = cut_out(u.alpha_mask, surface_uv);
  if (u.is_blended != 0) cut = !cut;
  return cut;
}
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
  if (any_lane(!left_out)) pane_transmittance = Vec4(let_through(ray_direction()), Float(1.0f));
}
#endif
