// The nearest caster surface seen from the light, or the camera: of the light's view every texel is a grid
// vertex. DETAILED: with the normals and holes of its textures; TINTED: and their colours
// (textured_casters.md).
#include "passes/shared/caster_surface.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, caster_position)
OUTPUT(1, Vec4, caster_normal)
#ifdef TINTED
OUTPUT(2, Vec4, caster_tint)

// What glass lets through of each channel, or metal mirrors of it at normal incidence.
Vec3 caster_color_here() {
  Vec3 color = Vec3(u.color_factor);
  if (u.has_base_color != 0) color = color * Vec3(fetch_wrapped(base_color, u.mask.uv, color_uv));
  if (u.has_transmission != 0) {
    color = color * fetch_wrapped(transmission_texture, u.transmission_uv, transmission_uv).x;
  }
  return color + Vec3(u.color_offset);
}
#endif

void main() {
  discard_if(is_not_drawn() || is_edge_on(surface_position));
  Float number = Float(0.0f);
  if (u.first_triangle >= 0) number = Float(primitive_id() + u.first_triangle + 1);
  caster_position = Vec4(surface_position, sel(front_facing(), number + 1.0f, -1.0f - number));
  caster_normal = Vec4(caster_normal_here(), Float(u.material_row));
#ifdef TINTED
  caster_tint = Vec4(caster_color_here(), Float(1.0f));
#endif
}
#endif
