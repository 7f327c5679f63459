// The light that falls on a grid vertex's cell. Needs view_space.glsl, cube_atlas.glsl, cone_falloff.glsl,
// and of the uniforms caster, cone, light, cell_area and a cube's tiles; with HAZE medium_optics.glsl.

struct GridCell {
  Bool covered;  // there is a caster
  Int face;      // of a cube's caster map: whose tile the vertex is in, and whether beyond
  Bool guard;    // that face, where it belongs to another and carries no flux
};

// Of a cube's caster map: in which tile does the grid vertex lie, and where in it?
GridCell cell_in_tile(Int column, Int row, Bool covered) {
  Float tile_column = floor((Float(column) + 0.5f) / u.tile_width);
  Float tile_row = floor((Float(row) + 0.5f) / u.tile_height);
  Float x = Float(column) - tile_column * u.tile_width;
  Float y = Float(row) - tile_row * u.tile_height;
  float guard = u.tile_guard;
  GridCell cell;
  cell.face = floor_to_int(tile_row * 3.0f + tile_column);
  cell.guard = x < guard || x >= u.tile_width - guard || y < guard || y >= u.tile_height - guard;
  // What is left over at the texture's edge is no tile.
  cell.covered = covered && tile_column < 2.5f && tile_row < 1.5f;
  return cell;
}

GridCell cell_of(Int column, Int row, Bool covered) {
  GridCell cell;
  cell.covered = covered;
  cell.face = Int(FACE_FORWARD);
  cell.guard = Bool(false);
  if (u.caster.kind == VIEW_CUBE) cell = cell_in_tile(column, row, covered);
  return cell;
}

struct Incident {
  Vec3 from;  // as the uniform light has it: where it starts, or of parallel light the way it travels
  Vec3 direction;
  Float flux;  // relative to the light's intensity
};

// The solid angle of a grid vertex's cell from a point light, by the midpoint form. q: the vertex, in view
// coordinates.
Float solid_angle(Vec3 q, Int face, Bool covered) {
  Vec3 t = in_face(u.caster, q, face);
  Float w = sel(covered, t.z, Float(1.0f));
  Float x = t.x / w;
  Float y = t.y / w;
  Float squared = 1.0f + x * x + y * y;
  return u.cell_area / (squared * sqrt(squared));
}

// The flux onto the cell of the vertex at p is its area across parallel light; its solid angle from a point,
// times the cone's falloff.
Incident light_from_view(IN(GridCell) cell, Vec3 p) {
  Incident light;
  light.from = Vec3(u.light);
  light.direction = light.from;
  light.flux = Float(u.cell_area);
  if (u.caster.kind != VIEW_PARALLEL) {
    light.direction = normalize_or(p - Vec3(u.light), Vec3(u.cone.axis));
    light.flux = solid_angle(view_coordinates(u.caster, p), cell.face, cell.covered) *
                 cone_falloff(u.cone, light.direction);
  }
  light.flux = sel(cell.covered && !cell.guard, light.flux, Float(0.0f));
  return light;
}

Incident light_onto(IN(GridCell) cell, Vec3 p) {
  Incident light = light_from_view(cell, p);
  TRACE(light_direction, light.direction);
  return light;
}

#ifdef HAZE
// How far light has come through the medium to p: from where it starts, which lies in the box, or from where
// it enters that. `from`: as Incident has it.
Float air_before(Vec3 p, Vec3 from) {
  Float way = Float(0.0f);
  if (u.caster.kind == VIEW_PARALLEL) {
    way = medium_exit(u.medium, ray_from(p, -from));
  } else {
    way = length3(p - from);
  }
  return way;
}
#endif
