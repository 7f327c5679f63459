// Receivers seen from the light: their positions (the positions texture of Shah et al. 2007).
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/receiver_map/receiver_map_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
VARYING_SMOOTH(0, Vec3, surface_position)
VARYING_SMOOTH(3, Vec2, surface_uv)

#ifdef VERTEX_STAGE
ATTRIBUTE(0, Vec3, position)
ATTRIBUTE(3, Vec2, uv)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"

void main() {
  surface_position = position;
  surface_uv = uv;
  set_position(view_clip(u.view, view_coordinates(u.view, position)));
}
#else
OUTPUT(0, Vec4, receiver_position)
#include "passes/shared/alpha_mask.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/casters_column.glsl"
#include "passes/shared/outside_tile.glsl"

void main() {
  discard_if(outside_tile(u.view, u.map_side));
  discard_if(cut_out(u.mask, surface_uv) ||
             stands_before_casters(u.column, u.casters_nearest, view_coordinates(u.view, surface_position)));
  receiver_position = Vec4(surface_position, Float(1.0f));
}
#endif
