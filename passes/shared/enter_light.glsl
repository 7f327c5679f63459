// Light at a grid vertex, where it meets its first surface. Needs caster_triangles.glsl, grid_light.glsl,
// light_path.glsl, the textures caster_position, caster_normal, caster_triangle and reaching, and the
// uniforms of grid_light_uniforms.glsl and is_tinted.

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

// What a vertex has met, and the light that comes to it.
struct Entry {
  Bool covered;  // there is a caster
  CasterTriangle triangle;
  Meeting at;
  Int material;  // row of caster_materials
  LightPath path;
};

Entry entry_at(Int column, Int row) {
  Vec4 position = texel_fetch(caster_position, column, row);
  Vec4 normal = texel_fetch(caster_normal, column, row);
  Float number = texel_fetch(caster_triangle, column, row).x - 1.0f;
  GridCell cell = cell_of(column, row, is_covered(position) && number >= 0.0f);
  Entry entry;
  entry.covered = cell.covered;
  entry.triangle = fetch_triangle(max_of(number, 0.0f));
  entry.material = material_row(normal);
  entry.at.point = Vec3(position);
  entry.at.outward = Vec3(normal);
  entry.at.plane = normalize_or(cross3(entry.triangle.edge1, entry.triangle.edge2), entry.at.outward);
  entry.at.front = !is_back_face(position);
  entry.at.number = number;
  entry.at.stretch = Float(0.0f);
  Incident light = light_onto(cell, entry.at.point);
  if (u.is_tinted != 0) light.flux = light.flux * texel_fetch(reaching, column, row).x;
  entry.path.ray = ray_from(entry.at.point, light.direction);
  entry.path.own = number;
  entry.path.path = Float(0.0f);
  entry.path.flux = Vec3(light.flux);
  entry.path.whole = light.flux;
  entry.path.media = Vec4(0.0f);
  set_differential(cell, entry.at.point, entry.path);
  TRACE(entry_point, entry.at.point);
  return entry;
}
