// An opaque surface drawn into a view, with what cuts holes into it. Expects the texture base_color and the
// uniforms of receiver_map_uniforms.glsl.
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
#include "passes/shared/wrapped.glsl"
#include "passes/shared/alpha_mask.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/outside_tile.glsl"
#endif
