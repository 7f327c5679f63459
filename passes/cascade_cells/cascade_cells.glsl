// Lays the cells into the cascade: those that touch its window, cut at its edge. cascade_cells.md explains.
UNIFORMS_BEGIN
#include "passes/cascade_cells/cascade_cells_uniforms.glsl"
UNIFORMS_END
#include "passes/caustic_cells/carried_cell.glsl"

#ifdef VERTEX_STAGE
Vec4 in_cascade(Vec4 corners) {
  return Vec4(corners.x * u.scale.x + u.offset.x, corners.y * u.scale.y + u.offset.y,
              corners.z * u.scale.x + u.offset.x, corners.w * u.scale.y + u.offset.y);
}

// A rectangle of two triangles around the texels that the cell touches: a cell may be larger here than any
// point.
void main() {
  Int id = vertex_id();
  Int cell = id / Int(6);
  Int corner = id - cell * Int(6);
  Int row = cell / Int(u.cells_a_side);
  Int column = cell - row * Int(u.cells_a_side);
  Vec4 carried = texel_fetch(cell_flux, column, row);
  near = in_cascade(texel_fetch(cell_near, column, row));
  far = in_cascade(texel_fetch(cell_far, column, row));
  flux = Vec3(carried);
  Float side = Float(float(u.map_side));
  Float left = max_of(floor(min_of(min_of(near.x, near.z), min_of(far.x, far.z))), Float(0.0f));
  Float bottom = max_of(floor(min_of(min_of(near.y, near.w), min_of(far.y, far.w))), Float(0.0f));
  Float right = min_of(floor(max_of(max_of(near.x, near.z), max_of(far.x, far.z))) + 1.0f, side);
  Float top = min_of(floor(max_of(max_of(near.y, near.w), max_of(far.y, far.w))) + 1.0f, side);
  Bool to_right = corner == 1 || corner == 2 || corner == 4;
  Bool upwards = corner == 2 || corner == 4 || corner == 5;
  Vec4 at = Vec4(sel(to_right, right, left) * 2.0f / side - 1.0f,
                 sel(upwards, top, bottom) * 2.0f / side - 1.0f,
                 Float(0.5f), Float(1.0f));
  // Outside the volume: not drawn.
  Bool touches = is_cell(carried) && right > left && top > bottom;
  set_position(sel(touches, at, Vec4(2.0f, 2.0f, 0.5f, 1.0f)));
}
#endif
