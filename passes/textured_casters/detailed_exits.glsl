// The nearest back faces of the solid casters, with the normals and holes of their textures.
// textured_casters.md explains.
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/textured_casters/textured_casters_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
TEXTURE(1, normal_texture)
#include "passes/textured_casters/textured_surface.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, caster_exit_position)
OUTPUT(1, Vec4, caster_exit_normal)

void main() {
  discard_if(elsewhere() || cut_out_here());
  caster_exit_position = Vec4(surface_position, Float(1.0f));
  caster_exit_normal = Vec4(caster_normal_here(), Float(1.0f));
}
#endif
