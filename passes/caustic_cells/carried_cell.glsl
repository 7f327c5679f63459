// The head of the passes that lay cells into a map: the cell that a vertex belongs to, and what its fragments
// give to the texels.
TEXTURE(0, cell_near)
TEXTURE(1, cell_far)
TEXTURE(2, cell_flux)
VARYING_FLAT(0, Vec4, near)
VARYING_FLAT(4, Vec4, far)
VARYING_FLAT(8, Vec3, flux)

#ifdef VERTEX_STAGE
#include "passes/caustic_cells/cell_texel.glsl"
#else
#include "passes/caustic_cells/overlap.glsl"
#endif
