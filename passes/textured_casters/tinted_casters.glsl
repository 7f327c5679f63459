// The nearest casters, with the normals, holes and colours of their textures. textured_casters.md explains.
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/textured_casters/textured_casters_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
TEXTURE(1, normal_texture)
TEXTURE(2, transmission_texture)
#include "passes/textured_casters/textured_surface.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, caster_position)
OUTPUT(1, Vec4, caster_normal)
OUTPUT(2, Vec4, caster_tint)

// What glass lets through of each channel, or metal mirrors of it at normal incidence.
Vec3 caster_color_here() {
  Vec3 color = Vec3(u.color_factor);
  if (u.has_base_color != 0) color = color * Vec3(fetch_repeat(base_color, color_uv.x, color_uv.y));
  if (u.has_transmission != 0)
    color = color * fetch_repeat(transmission_texture, transmission_uv.x, transmission_uv.y).x;
  return color + Vec3(u.color_offset);
}

void main() {
  discard_if(elsewhere() || cut_out_here());
  caster_position = Vec4(surface_position, sel(front_facing(), Float(1.0f), Float(-1.0f)));
  caster_normal = Vec4(caster_normal_here(), Float(u.material_row));
  caster_tint = Vec4(caster_color_here(), Float(1.0f));
}
#endif
