// Receivers seen from the light: their positions (the positions texture of Shah et al. 2007).
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/receiver_map/receiver_map_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
#include "passes/shared/masked_surface.glsl"

#ifndef VERTEX_STAGE
OUTPUT(0, Vec4, receiver_position)
#include "passes/shared/casters_column.glsl"

void main() {
  discard_if(outside_tile(u.view, u.map_side));
  discard_if(Bool(u.without_towards != 0) && front_facing());
  discard_if(Bool(u.without_away != 0) && !front_facing());
  discard_if(cut_out(u.mask, surface_uv) ||
             stands_before_casters(u.column, u.casters_nearest, view_coordinates(u.view, surface_position)));
  receiver_position = Vec4(surface_position, Float(1.0f));
}
#endif
