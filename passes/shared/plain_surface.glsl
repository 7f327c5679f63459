// A caster without textures drawn into a view: vertex stage, and its outward normal.
VARYING_SMOOTH(0, Vec3, surface_position)
VARYING_SMOOTH(3, Vec3, surface_normal)

#ifdef VERTEX_STAGE
ATTRIBUTE(0, Vec3, position)
ATTRIBUTE(3, Vec3, normal)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/mesh_vertex.glsl"
#else
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/outside_tile.glsl"

Bool is_not_drawn() { return outside_tile(u.view, u.map_side); }

Vec3 caster_normal_here() { return normalize_or(surface_normal, Vec3(0.0f, 1.0f, 0.0f)); }
#endif
