// A thin pane drawn into a view: vertex stage, and what a ray through it keeps. Expects the texture
// base_color and the uniforms of pane_uniforms.glsl.
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

// The share of light that passes. A blended surface keeps what it covers. `in_picture`: where what is
// not let through has covered its share already.
Vec3 let_through(Vec3 d, Bool in_picture) {
  Vec4 texel = base_texel();
  Vec3 passes = Vec3(1.0f - u.alpha_mask.opacity * texel.w);
  if (u.is_blended == 0) {
    PaneLayer layer = layer_here(u.alpha_mask.opacity * texel.w);
    passes = pane_passes(layer, Vec3(u.color) * Vec3(texel), face_reflectance(d));
    passes = sel(in_picture, passes * (1.0f / layer_passes(layer)), passes);
  }
  return passes;
}

// Holes, or what of a blended surface is opaque.
Bool not_drawn() {
  Bool cut = cut_out(u.alpha_mask, surface_uv);
  if (u.is_blended != 0) cut = !cut;
  return cut;
}
#endif
