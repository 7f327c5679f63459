// Opaque surfaces seen from the light in the casters' view: depth alone, so that a caster in their
// shadow does not enter the caster map.
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/receiver_map/receiver_map_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
VARYING_SMOOTH(0, Vec2, surface_uv)

#ifdef VERTEX_STAGE
ATTRIBUTE(0, Vec3, position)
ATTRIBUTE(3, Vec2, uv)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"

void main() {
  surface_uv = uv;
  set_position(view_clip(u.view, view_coordinates(u.view, position)));
}
#else
#include "passes/shared/wrapped.glsl"
#include "passes/shared/alpha_mask.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/outside_tile.glsl"

void main() {
  discard_if(outside_tile(u.view, u.map_side));
  discard_if(cut_out(u.mask, surface_uv));
}
#endif
