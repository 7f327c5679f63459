// Receivers seen from the light: their positions (the positions texture of Shah et al. 2007).
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
  set_position(view_clip(view_coordinates(u.from_scene, position), u.window, u.depth));
}
#else
OUTPUT(0, Vec4, receiver_position)
#include "passes/shared/cutout.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/column.glsl"
#include "passes/shared/outside_tile.glsl"

void main() {
  if (u.depth.z > 1.5f) discard_if(outside_tile(u.window, u.depth, u.alpha.w));
  discard_if(cut_out(surface_uv) ||
             stands_before_casters(view_coordinates(u.from_scene, surface_position)));
  receiver_position = Vec4(surface_position, Float(1.0f));
}
#endif
