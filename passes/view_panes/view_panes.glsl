// Thin panes as the camera sees them: what lies behind is tinted, the environment mirrored on top.
#include "passes/shared/sky_model.glsl"
#include "passes/shared/light_cone.glsl"
#include "passes/shared/light.glsl"
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/shared/pane_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
TEXTURE(1, view_position)
TEXTURE(2, view_normal)
TEXTURE(3, view_caster_position)
TEXTURE(4, environment)
TEXTURE(5, transmission_texture)
#include "passes/shared/pane_surface.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, beauty)
#include "passes/shared/position_texel.glsl"
#include "passes/shared/sky_radiance.glsl"
#include "passes/shared/cone_falloff.glsl"
#include "passes/shared/light_falloff.glsl"
#include "passes/shared/incidence.glsl"
#include "passes/shared/highlight.glsl"

// Does an opaque surface or glass stand before the pane?
Bool hidden() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Float z = view_coordinates(u.view, surface_position).z;
  Bool surface = is_covered(texel_fetch(view_position, column, row));
  Float surface_z = texel_fetch(view_normal, column, row).w;
  Vec4 glass = fetch_clamped(view_caster_position, column, row);
  Float glass_z = view_coordinates(u.view, Vec3(glass)).z;
  return (surface && surface_z < z) || (is_covered(glass) && glass_z < z);
}

// Radiance along d that the pane, whose normal n faces the eye, mirrors of all around or of the light.
Vec3 mirrored(Vec3 n, Vec3 d) {
  Vec3 color = Vec3(0.0f);
  if (u.shows_light != 0) {
    Incidence light = incidence_of(u.light, surface_position, n);
    Float lobe = highlight_lobe(n, -d, -light.travel, Float(u.roughness), half_width(u.light, light));
    color = Vec3(u.light.intensity) * (light.facing * light.falloff / light.spread * lobe);
  } else {
    color = sky_radiance(u.sky, reflected(d, n, clamp_to(-dot3(d, n), 0.0f, 1.0f)));
  }
  return color;
}

void main() {
  discard_if(not_drawn() || hidden());
  Vec3 d = ray_direction();
  Vec3 color = let_through(d, Bool(u.has_layer != 0));
  if (u.shows_mirror != 0) {
    // Both faces together mirror 2 r / (1 + r).
    Float r = face_reflectance(d);
    Vec3 n = facing_normal(normalize_or(surface_normal, -d), d, dot3(surface_normal, d) > 0.0f);
    Float opacity = u.alpha_mask.opacity * base_texel().w;
    PaneLayer layer = layer_here(opacity);
    color = mirrored(n, d) * (layer.there * (2.0f * r / (1.0f + r)));
  }
  beauty = Vec4(color, Float(1.0f));
}
#endif
