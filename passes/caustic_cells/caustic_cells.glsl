// Adds every cell to the caustic map: each of its two triangles gives a texel its flux times the share of
// the triangle's area that lies on the texel, exactly. caustic_cells.md explains.
UNIFORMS_BEGIN
#include "passes/caustic_cells/caustic_cells_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, cell_near)
TEXTURE(1, cell_far)
TEXTURE(2, cell_flux)
#include "passes/caustic_cells/rectangle_around.glsl"

#ifdef VERTEX_STAGE
#include "passes/caustic_cells/cell_texel.glsl"

Vec4 on_drawn_map(Vec4 corners) {
  return Vec4(corners.x * u.scale.x + u.offset.x, corners.y * u.scale.y + u.offset.y,
              corners.z * u.scale.x + u.offset.x, corners.w * u.scale.y + u.offset.y);
}

void main() {
  Int id = rectangle_id();
  Int row = id / Int(u.cells_a_side);
  Int column = id - row * Int(u.cells_a_side);
  Vec4 carried = texel_fetch(cell_flux, column, row);
  flux = Vec3(carried);
  Vec4 a_and_b = on_drawn_map(texel_fetch(cell_near, column, row));
  Vec4 c_and_d = on_drawn_map(texel_fetch(cell_far, column, row));
  lay_quad(a_and_b, c_and_d, Float(float(u.map_side)), is_cell(carried));
}
#else
#include "passes/caustic_cells/overlap.glsl"
#endif
