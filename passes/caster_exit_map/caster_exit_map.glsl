// The nearest back face of the solid casters seen from the light, or the camera: where a ray can leave again.
// DETAILED: with the normals and holes of its textures (textured_casters.md).
#include "passes/shared/caster_surface.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, caster_exit_position)
OUTPUT(1, Vec4, caster_exit_normal)

void main() {
  discard_if(is_not_drawn() || is_edge_on(surface_position));
  caster_exit_position = Vec4(surface_position, Float(1.0f));
  caster_exit_normal = Vec4(caster_normal_here(), Float(1.0f));
}
#endif
