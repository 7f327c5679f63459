// The nearest back face of the solid casters seen from the light: where a ray can leave again.
UNIFORMS_BEGIN
#include "passes/caster_map/caster_map_uniforms.glsl"
UNIFORMS_END
VARYING_SMOOTH(0, Vec3, surface_position)
VARYING_SMOOTH(3, Vec3, surface_normal)

#ifdef VERTEX_STAGE
ATTRIBUTE(0, Vec3, position)
ATTRIBUTE(3, Vec3, normal)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/mesh_vertex.glsl"
#else
OUTPUT(0, Vec4, caster_exit_position)
OUTPUT(1, Vec4, caster_exit_normal)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/outside_tile.glsl"

void main() {
  discard_if(outside_tile(u.view, u.map_side));
  caster_exit_position = Vec4(surface_position, Float(1.0f));
  caster_exit_normal = Vec4(normalize_or(surface_normal, Vec3(0.0f, 1.0f, 0.0f)), Float(1.0f));
}
#endif
