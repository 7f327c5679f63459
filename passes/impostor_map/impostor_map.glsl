// Receivers seen from the middle of the casters, all around: their positions, for distance impostors.
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
OUTPUT(0, Vec4, impostor_position)
#include "passes/shared/cutout.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/outside_tile.glsl"

void main() {
  discard_if(outside_tile(u.window, u.depth, u.alpha.w) || cut_out(surface_uv));
  Float distance = length3(view_coordinates(u.from_scene, surface_position));
  impostor_position = Vec4(surface_position, max_of(distance, 1.0e-30f));
}
#endif
