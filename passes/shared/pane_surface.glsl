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

// Reflectance of one of the pane's two faces for a ray along d.
Float face_reflectance(Vec3 d) {
  Float cosine = abs(dot3(normalize_or(surface_normal, d), d));
  Float eta = Float(1.0f / u.ior);
  return fresnel_reflectance(eta, cosine, sqrt(max_of(transmitted_cosine_squared(eta, cosine), 0.0f)));
}

// What light keeps on its way through: between two parallel faces the reflections add up to
// (1 - r) / (1 + r), whatever the pane's thickness; the colour counts once. A blended surface keeps what it
// covers.
Vec3 let_through(Vec3 d) {
  Vec4 texel = Vec4(1.0f);
  if (u.has_base_color != 0)
    texel = fetch_wrapped(base_color, u.base_color_uv, transformed_uv(u.base_color_uv, surface_uv));
  Vec3 passes = Vec3(1.0f - u.alpha_mask.opacity * texel.w);
  if (u.is_blended == 0) {
    Float r = face_reflectance(d);
    passes = Vec3(u.color) * Vec3(texel) * ((1.0f - r) / (1.0f + r));
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
