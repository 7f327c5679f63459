// Light at a grid vertex, where it meets its first surface. Needs caster_triangles.glsl, grid_light.glsl,
// wide_light.glsl, light_path.glsl, way_draw.glsl, the textures caster_position, caster_normal,
// hierarchy_normals and reaching, and the uniforms of grid_light_uniforms.glsl, light_shape
// and is_tinted.

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

// Light that has come to a surface.
struct Arrival {
  Bool covered;  // of a grid vertex: there is a caster
  CasterTriangle triangle;
  Meeting at;
  Int material;  // row of caster_materials
  Vec3 from;     // Incident::from
  LightPath path;
};

// `drawn`: a whole number for the light's point, where it has a size.
Incident light_at_vertex(IN(GridCell) cell, IN(Meeting) at, Float drawn) {
  Incident light;
  if (u.light_shape != 0) {
    light = light_of_size(cell, at.point, at.plane, drawn);
  } else {
    light = light_onto(cell, at.point);
  }
  return light;
}

Arrival arrival_at(Int column, Int row, Float drawn) {
  Vec4 position = texel_fetch(caster_position, column, row);
  Vec4 normal = texel_fetch(caster_normal, column, row);
  Float number = triangle_number(position);
  GridCell cell = cell_of(column, row, is_covered(position) && number >= 0.0f);
  Arrival arrival;
  arrival.covered = cell.covered;
  arrival.triangle = fetch_triangle(max_of(number, 0.0f));
  arrival.material = material_row(normal);
  arrival.at = meeting_in_view(position, normal);
  arrival.at.plane = plane_of(arrival.triangle, arrival.at.outward);
  arrival.at.number = number;
  Incident light = light_at_vertex(cell, arrival.at, drawn);
  Vec3 tint = Vec3(1.0f);
  if (u.is_tinted != 0) {
    tint = Vec3(texel_fetch(reaching, column, row));
    Float most = max_of(max_of(tint.x, tint.y), tint.z);
    light.flux = light.flux * most;
    tint = tint * (1.0f / max_of(most, 1.0e-6f));
  }
  // A lamp's points on the sides that look away send nothing.
  if (u.light_shape == 5) arrival.covered = arrival.covered && light.flux > 0.0f;
  arrival.from = light.from;
  arrival.path.ray = ray_from(arrival.at.point, light.direction);
  arrival.path.own = number;
  arrival.path.aside = Bool(false);
  arrival.path.parted = Bool(u.draws == 0);
  arrival.path.path = drawn;
  arrival.path.flux = Vec3(light.flux);
  if (u.is_tinted != 0) arrival.path.flux = tint * light.flux;
  arrival.path.whole = light.flux;
  arrival.path.media = Vec4(0.0f);
  set_differential(cell, arrival.at.point, arrival.path);
  if (u.light_shape != 0) spread_by_size(arrival.path);
  TRACE(entry_point, arrival.at.point);
  return arrival;
}
