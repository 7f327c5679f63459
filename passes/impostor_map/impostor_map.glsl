// Receivers seen from the middle of the casters, all around: their positions, for distance impostors.
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/receiver_map/receiver_map_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
#include "passes/shared/masked_surface.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, impostor_position)

void main() {
  discard_if(outside_tile(u.view, u.map_side) || cut_out(u.mask, surface_uv));
  Float distance = length3(view_coordinates(u.view, surface_position));
  impostor_position = Vec4(surface_position, max_of(distance, 1.0e-30f));
}
#endif
