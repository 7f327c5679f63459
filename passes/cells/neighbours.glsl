// Where the neighbours of a grid vertex are stored. Over the border of a cube's tile the grid goes on with
// the vertices of the face beyond the edge, at the same distance from it. Needs cube_atlas.glsl and the
// uniforms caustic, grid_side, grid_tile and grid_guard.
struct Place {
  Int x;
  Int y;
  Bool exists;  // there is such a vertex; beyond two borders at once, at the cube's corners, there is none
};

// (x, y) counted on in the tile that (home_x, home_y) is in.
Place place_at(Int x, Int y, Int home_x, Int home_y) {
  Place place;
  place.x = x;
  place.y = y;
  place.exists = x >= 0 && y >= 0 && x < u.grid_side && y < u.grid_side;
  if (u.caustic.kind == VIEW_CUBE) {
    float size = u.grid_tile;
    float radius = 0.5f * size - u.grid_guard;
    Float column = floor((Float(home_x) + 0.5f) / size);
    Float row = floor((Float(home_y) + 0.5f) / size);
    // On the face, -1 to 1, and beyond.
    Float tx = (Float(x) + 0.5f - (column + 0.5f) * size) / radius;
    Float ty = (Float(y) + 0.5f - (row + 0.5f) * size) / radius;
    Bool over_x = abs(tx) > 1.0f;
    Bool over_y = abs(ty) > 1.0f;
    // What lies beyond is folded back over the edge.
    Vec3 t = Vec3(tx, ty, Float(1.0f));
    t = sel(over_y, Vec3(tx, sel(ty < 0.0f, Float(-1.0f), Float(1.0f)), 2.0f - abs(ty)), t);
    t = sel(over_x, Vec3(sel(tx < 0.0f, Float(-1.0f), Float(1.0f)), ty, 2.0f - abs(tx)), t);
    Vec3 q = cube_unturned(t, floor_to_int(row * 3.0f + column));
    Int face = cube_face(q);
    Vec3 there = cube_turned(q, face);
    Vec2 middle = cube_middle(face);
    place.x = floor_to_int(middle.x * (0.5f * size) + there.x * radius);
    place.y = floor_to_int(middle.y * (0.5f * size) + there.y * radius);
    place.exists = column < 2.5f && row < 1.5f && !(over_x && over_y);
  }
  return place;
}
