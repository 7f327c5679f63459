// Opaque surfaces seen from the light: how far along the light they lie.
UNIFORMS_BEGIN
#include "passes/receiver_map/receiver_map_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
VARYING_SMOOTH(0, Vec3, surface_position)
VARYING_SMOOTH(3, Vec2, surface_uv)

#ifdef VERTEX_STAGE
ATTRIBUTE(0, Vec3, position)
ATTRIBUTE(3, Vec2, uv)
#include "passes/shared/frame_space.glsl"

void main() {
  surface_position = position;
  surface_uv = uv;
  set_position(frame_clip(frame_coordinates(u.from_scene, position), u.window, u.depth));
}
#else
OUTPUT(0, Vec4, shadow_depth)
#include "passes/shared/cutout.glsl"
#include "passes/shared/frame_space.glsl"

void main() {
  discard_if(cut_out(surface_uv));
  Float z = frame_coordinates(u.from_scene, surface_position).z;
  shadow_depth = Vec4(z, Float(0.0f), Float(0.0f), Float(1.0f));
}
#endif
