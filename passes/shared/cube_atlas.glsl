// The six faces of a cube in one texture: pipeline/scene/cube_atlas.hpp. Face f looks along +x, -x, +y, -y,
// +z, -z of the view (FACE_RIGHT to FACE_BACKWARD) and lies in tile (f mod 3, f / 3), counted from the lower
// left.

// The face that a direction lies in: that of its largest component; of equal ones z wins over x, x over y, so
// that every direction has one face.
Int cube_face(Vec3 q) {
  Float x = abs(q.x);
  Float y = abs(q.y);
  Float z = abs(q.z);
  Bool along_z = z >= x && z >= y;
  Int face_z = sel(q.z >= 0.0f, Int(FACE_FORWARD), Int(FACE_BACKWARD));
  Int face_x = sel(q.x >= 0.0f, Int(FACE_RIGHT), Int(FACE_LEFT));
  Int face_y = sel(q.y >= 0.0f, Int(FACE_UP), Int(FACE_DOWN));
  return sel(along_z, face_z, sel(x >= y, face_x, face_y));
}

// q turned so that the face's axis is z: +x (-z, y, x), -x (z, y, -x), +y (x, -z, y), -y (x, z, -y), -z (-x,
// y, -z). All are rotations, so that front faces stay front faces.
Vec3 cube_turned(Vec3 q, Int face) {
  Vec3 turned = sel(face == FACE_BACKWARD, Vec3(-q.x, q.y, -q.z), q);
  turned = sel(face == FACE_RIGHT, Vec3(-q.z, q.y, q.x), turned);
  turned = sel(face == FACE_LEFT, Vec3(q.z, q.y, -q.x), turned);
  turned = sel(face == FACE_UP, Vec3(q.x, -q.z, q.y), turned);
  return sel(face == FACE_DOWN, Vec3(q.x, q.z, -q.y), turned);
}

// cube_turned back.
Vec3 cube_unturned(Vec3 t, Int face) {
  Vec3 q = sel(face == FACE_BACKWARD, Vec3(-t.x, t.y, -t.z), t);
  q = sel(face == FACE_RIGHT, Vec3(t.z, t.y, -t.x), q);
  q = sel(face == FACE_LEFT, Vec3(-t.z, t.y, t.x), q);
  q = sel(face == FACE_UP, Vec3(t.x, t.z, -t.y), q);
  return sel(face == FACE_DOWN, Vec3(t.x, -t.z, t.y), q);
}

// Twice the tile's column and row, plus 1: times half a tile this is the tile's middle.
Vec2 cube_middle(Int face) {
  Int row = sel(face >= 3, Int(1), Int(0));
  Int column = face - row * 3;
  return Vec2(Float(column) * 2.0f + 1.0f, Float(row) * 2.0f + 1.0f);
}
