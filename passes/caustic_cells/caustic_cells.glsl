// Adds every cell to the caustic map: each of its two triangles gives a texel its flux times the share of
// the triangle's area that lies on the texel, exactly. caustic_cells.md explains.
UNIFORMS_BEGIN
#include "passes/caustic_cells/caustic_cells_uniforms.glsl"
UNIFORMS_END
#include "passes/caustic_cells/carried_cell.glsl"

#ifdef VERTEX_STAGE
#include "passes/shared/splat.glsl"

// One square point over the texels that the cell touches: its corners are corners of texels.
void main() {
  Int id = vertex_id();
  Int row = id / Int(u.cells_a_side);
  Int column = id - row * Int(u.cells_a_side);
  Vec4 carried = texel_fetch(cell_flux, column, row);
  near = texel_fetch(cell_near, column, row);
  far = texel_fetch(cell_far, column, row);
  flux = Vec3(carried);
  Float left = floor(min_of(min_of(near.x, near.z), min_of(far.x, far.z)));
  Float bottom = floor(min_of(min_of(near.y, near.w), min_of(far.y, far.w)));
  Float right = floor(max_of(max_of(near.x, near.z), max_of(far.x, far.z))) + 1.0f;
  Float top = floor(max_of(max_of(near.y, near.w), max_of(far.y, far.w))) + 1.0f;
  Float side = max_of(right - left, top - bottom);
  // At the map's edge the square leans inwards, so that its centre, by which points are clipped, stays
  // inside.
  Float x = max_of(min_of(left, float(u.map_side) - side), Float(0.0f)) * 2.0f + side;
  Float y = max_of(min_of(bottom, float(u.map_side) - side), Float(0.0f)) * 2.0f + side;
  Vec4 at = Vec4(x / float(u.map_side) - 1.0f, y / float(u.map_side) - 1.0f, Float(0.5f), Float(1.0f));
  set_position(splat_position(at, is_cell(carried)));
  set_point_size(side);
}
#endif
