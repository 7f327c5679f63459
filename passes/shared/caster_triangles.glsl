// A caster's triangle, or a receiver's, as the textures hierarchy_triangles and hierarchy_normals hold them
// (pipeline/scene/hierarchy_tables.hpp). Needs meeting.glsl.
struct CasterTriangle {
  Vec3 corner;   // the first of its corners, scene space,
  Vec3 edge1;    // and the ways from there to the others
  Vec3 edge2;
  Vec3 normal;   // of the first corner,
  Vec3 turn1;    // and what the others' have more
  Vec3 turn2;
  Int row;       // of caster_materials
  Float body;    // that it bounds: a row of caster_materials plus 1
};

// `number`: a whole number, of a triangle that there is.
CasterTriangle fetch_triangle(Float number) {
  Int at = Int(number) * 3;
  Vec4 normal0 = table_fetch(hierarchy_normals, at, 0);
  Vec4 normal1 = table_fetch(hierarchy_normals, at, 1);
  Vec4 normal2 = table_fetch(hierarchy_normals, at, 2);
  Int place = Int(normal0.w) * 3;
  Vec4 corner0 = table_fetch(hierarchy_triangles, place, 0);
  Vec4 corner1 = table_fetch(hierarchy_triangles, place, 1);
  Vec4 corner2 = table_fetch(hierarchy_triangles, place, 2);
  CasterTriangle triangle;
  triangle.corner = Vec3(corner0);
  triangle.edge1 = Vec3(corner1) - triangle.corner;
  triangle.edge2 = Vec3(corner2) - triangle.corner;
  triangle.normal = Vec3(normal0);
  triangle.turn1 = Vec3(normal1) - triangle.normal;
  triangle.turn2 = Vec3(normal2) - triangle.normal;
  triangle.row = floor_to_int(corner1.w);
  triangle.body = corner2.w;
  return triangle;
}

// Its own normal, unit; of one without area the fallback.
Vec3 plane_of(IN(CasterTriangle) triangle, Vec3 fallback) {
  return normalize_or(cross3(triangle.edge1, triangle.edge2), fallback);
}

Meeting meeting_at(IN(CasterTriangle) triangle, Vec4 hit, Vec3 direction) {
  Meeting at;
  at.point = triangle.corner + (triangle.edge1 * hit.x + triangle.edge2 * hit.y);
  at.plane = plane_of(triangle, -direction);
  Vec3 mixed = triangle.normal + (triangle.turn1 * hit.x + triangle.turn2 * hit.y);
  at.outward = normalize_or(mixed, at.plane);
  at.front = dot3(at.plane, direction) < 0.0f;
  at.number = hit.w - 1.0f;
  at.stretch = hit.z;
  at.hole = Bool(false);
  return at;
}

// The weights of the second and third corner at a place on the triangle's plane, from its first corner, or
// what they change by along the plane; 0 where the triangle has no area.
Vec2 weights_at(IN(CasterTriangle) triangle, Vec3 offset) {
  Vec3 across = cross3(triangle.edge1, triangle.edge2);
  Float squared = dot3(across, across);
  Bool sound = squared > 1.0e-30f;
  Float inverse = sel(sound, 1.0f / sel(sound, squared, Float(1.0f)), Float(0.0f));
  Vec3 beside1 = cross3(offset, triangle.edge2);
  Vec3 beside2 = cross3(triangle.edge1, offset);
  return Vec2(dot3(beside1, across) * inverse, dot3(beside2, across) * inverse);
}

// How the smooth normal turns where the meeting moves over the triangle's plane (Igehy 1999, equations 14 and
// 15).
Vec3 normal_turn(IN(CasterTriangle) triangle, IN(Meeting) at, Vec3 moved) {
  Vec2 weights = weights_at(triangle, at.point - triangle.corner);
  Vec3 mixed = triangle.normal + (triangle.turn1 * weights.x + triangle.turn2 * weights.y);
  Vec2 change = weights_at(triangle, moved);
  Vec3 turn = triangle.turn1 * change.x + triangle.turn2 * change.y;
  Float length = max_of(length3(mixed), 1.0e-3f);
  return (turn - at.outward * dot3(turn, at.outward)) / length;
}
