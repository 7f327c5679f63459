// Light's first surface: each grid vertex sends a ray into the casters, or off them. enter.md explains.
#include "passes/shared/light_cone.glsl"
UNIFORMS_BEGIN
#include "passes/enter/enter_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, caster_position)
TEXTURE(1, caster_normal)
TEXTURE(2, caster_triangle)
TEXTURE(3, caster_materials)
TEXTURE(4, hierarchy_triangles)
TEXTURE(5, hierarchy_normals)
TEXTURE(6, reaching)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
#include "passes/shared/ray_outputs.glsl"
#include "passes/shared/axes_across.glsl"
#include "passes/shared/caster_material.glsl"
#include "passes/shared/caster_triangles.glsl"
#include "passes/shared/cone_falloff.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/absorption.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/refraction.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/grid_light.glsl"
#include "passes/shared/light_path.glsl"
#include "passes/shared/media.glsl"
#include "passes/shared/interface.glsl"
#include "passes/shared/bend_light.glsl"

// A direction of the view's axes, as a cube's face turns them, in scene space.
Vec3 grid_axis(Vec3 axis, Int face) {
  Vec3 q = axis;
  if (u.caster.kind == VIEW_CUBE) q = cube_unturned(axis, face);
  mat4 m = u.caster.from_scene;
  return Vec3(m[0].x * q.x + m[0].y * q.y + m[0].z * q.z, m[1].x * q.x + m[1].y * q.y + m[1].z * q.z,
              m[2].x * q.x + m[2].y * q.y + m[2].z * q.z);
}

// Parallel light is moved from one vertex to the next, light from a point turned.
void set_differential(IN(GridCell) cell, Vec3 point, INOUT(LightPath) path) {
  Vec3 x = grid_axis(Vec3(1.0f, 0.0f, 0.0f), cell.face) * (1.0f / (u.caster.scale.x * float(u.grid_side)));
  Vec3 y = grid_axis(Vec3(0.0f, 1.0f, 0.0f), cell.face) * (1.0f / (u.caster.scale.y * float(u.grid_side)));
  path.width_x = x;
  path.width_y = y;
  path.spread_x = Vec3(0.0f);
  path.spread_y = Vec3(0.0f);
  if (u.caster.kind != VIEW_PARALLEL) {
    Vec3 d = path.ray.direction;
    Vec3 way = point - Vec3(u.light);
    Float along = dot3(way, grid_axis(Vec3(0.0f, 0.0f, 1.0f), cell.face));
    Float metres = max_of(along, 1.0e-20f);
    path.width_x = (x - d * dot3(x, d)) * metres;
    path.width_y = (y - d * dot3(y, d)) * metres;
    Float inverse = 1.0f / max_of(length3(way), 1.0e-20f);
    path.spread_x = path.width_x * inverse;
    path.spread_y = path.width_y * inverse;
  }
}

Meeting first_meeting(Vec4 position, Vec4 normal, Float number, IN(CasterTriangle) triangle) {
  Meeting at;
  at.point = Vec3(position);
  at.outward = Vec3(normal);
  at.plane = normalize_or(cross3(triangle.edge1, triangle.edge2), at.outward);
  at.front = !is_back_face(position);
  at.number = number;
  at.stretch = Float(0.0f);
  return at;
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 position = texel_fetch(caster_position, column, row);
  Vec4 normal = texel_fetch(caster_normal, column, row);
  Float number = texel_fetch(caster_triangle, column, row).x - 1.0f;
  GridCell cell = cell_of(column, row, is_covered(position) && number >= 0.0f);
  Material material = fetch_material(caster_materials, material_row(normal));
  CasterTriangle triangle = fetch_triangle(max_of(number, 0.0f));
  Meeting at = first_meeting(position, normal, number, triangle);
  Incident light = light_onto(cell, at.point);
  if (u.is_tinted != 0) light.flux = light.flux * texel_fetch(reaching, column, row).x;
  LightPath path;
  path.ray = ray_from(at.point, light.direction);
  path.path = Float(0.0f);
  path.flux = Vec3(light.flux);
  path.whole = light.flux;
  path.media = Vec4(0.0f);
  set_differential(cell, at.point, path);
  TRACE(entry_point, at.point);
  bend_light(path, at, triangle, material, cell.covered);
  Vec3 booked = Vec3(landing_fresnel);
  if (u.follows_mirrored == 0) landing_fresnel = Vec4(booked, light.flux);
}
#endif
