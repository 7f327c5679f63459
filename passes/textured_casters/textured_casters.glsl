// Casters whose material has textures, seen from the light or the camera. CASTER_TINT: the colour is written
// too. CASTER_EXIT: what is drawn are back faces. textured_casters.md explains.
UNIFORMS_BEGIN
#include "passes/textured_casters/textured_casters_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
TEXTURE(1, normal_texture)
#if CASTER_TINT
TEXTURE(2, transmission_texture)
#endif
VARYING_SMOOTH(0, Vec3, surface_position)
VARYING_SMOOTH(3, Vec3, surface_normal)
VARYING_SMOOTH(6, Vec4, surface_tangent)
VARYING_SMOOTH(10, Vec2, surface_uv)

#ifdef VERTEX_STAGE
ATTRIBUTE(0, Vec3, position)
ATTRIBUTE(3, Vec3, normal)
ATTRIBUTE(6, Vec4, tangent)
ATTRIBUTE(10, Vec2, uv)
#include "passes/shared/frame_space.glsl"

void main() {
  surface_position = position;
  surface_normal = normal;
  surface_tangent = tangent;
  surface_uv = uv;
  set_position(frame_clip(frame_coordinates(u.from_scene, position), u.window, u.depth));
}
#else
OUTPUT(0, Vec4, caster_position)
OUTPUT(1, Vec4, caster_normal)
#if CASTER_TINT
OUTPUT(2, Vec4, caster_tint)
#endif
#include "passes/shared/cutout.glsl"
#include "passes/shared/material.glsl"
#include "passes/shared/tangent_space.glsl"

// The outward normal, leaned by the normal texture but never out of the hemisphere around the smooth normal:
// light enters and leaves a face through the side that was drawn.
Vec3 caster_normal_here() {
  Vec3 n = normalize_or(surface_normal, Vec3(0.0f, 1.0f, 0.0f));
  if (u.uses.y > 0.5f) {
    Vec2 at = transformed_uv(u.normal_row0, u.normal_row1, surface_uv);
    Vec3 local = tangent_space_normal(fetch_repeat(normal_texture, at.x, at.y), Float(u.material.y));
    local.z = max_of(local.z, 0.01f);
    n = leaned_normal(n, surface_tangent, local);
  }
  return n;
}

#if CASTER_TINT
// What glass lets through of each channel, or metal mirrors of it at normal incidence.
Vec3 caster_color_here() {
  Vec3 color = Vec3(u.color_factor);
  if (u.uses.x > 0.5f) {
    Vec2 at = transformed_uv(u.uv_row0, u.uv_row1, surface_uv);
    color = color * Vec3(fetch_repeat(base_color, at.x, at.y));
  }
  if (u.uses.z > 0.5f) {
    Vec2 at = transformed_uv(u.transmission_row0, u.transmission_row1, surface_uv);
    color = color * fetch_repeat(transmission_texture, at.x, at.y).x;
  }
  return color + Vec3(u.color_offset);
}
#endif

void main() {
  discard_if(cut_out(surface_uv));
#if CASTER_EXIT
  caster_position = Vec4(surface_position, Float(1.0f));
  caster_normal = Vec4(caster_normal_here(), Float(1.0f));
#else
  caster_position = Vec4(surface_position, sel(front_facing(), Float(1.0f), Float(-1.0f)));
  caster_normal = Vec4(caster_normal_here(), Float(u.material.x));
#endif
#if CASTER_TINT
  caster_tint = Vec4(caster_color_here(), Float(1.0f));
#endif
}
#endif
