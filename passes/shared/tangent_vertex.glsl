// What carries a normal texture: position, normal and tangent from the vertices to the fragments.
VARYING_SMOOTH(0, Vec3, surface_position)
VARYING_SMOOTH(3, Vec3, surface_normal)
VARYING_SMOOTH(6, Vec4, surface_tangent)

#ifdef VERTEX_STAGE
ATTRIBUTE(0, Vec3, position)
ATTRIBUTE(3, Vec3, normal)
ATTRIBUTE(6, Vec4, tangent)
ATTRIBUTE(10, Vec2, uv)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"

void place_surface() {
  surface_position = position;
  surface_normal = normal;
  surface_tangent = tangent;
  set_position(view_clip(u.view, view_coordinates(u.view, position)));
}
#endif
