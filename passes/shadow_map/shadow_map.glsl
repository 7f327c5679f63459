// Opaque surfaces seen from the light: how far along the light they lie.
UNIFORMS_BEGIN
#include "passes/receiver_map/receiver_map_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
VARYING_SMOOTH(0, Float, along)
VARYING_SMOOTH(1, Vec2, surface_uv)

#ifdef VERTEX_STAGE
ATTRIBUTE(0, Vec3, position)
ATTRIBUTE(3, Vec2, uv)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"

void main() {
  Vec3 q = view_coordinates(u.from_scene, position);
  along = in_face(q, floor_to_int(Float(u.depth.w)), u.depth).z;
  surface_uv = uv;
  set_position(view_clip(q, u.window, u.depth));
}
#else
OUTPUT(0, Vec4, shadow_depth)
#include "passes/shared/cutout.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/outside_tile.glsl"

void main() {
  if (u.depth.z > 1.5f) discard_if(outside_tile(u.window, u.depth, u.alpha.w));
  discard_if(cut_out(surface_uv));
  shadow_depth = Vec4(along, Float(0.0f), Float(0.0f), Float(1.0f));
}
#endif
