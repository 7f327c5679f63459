// What w means in the texture cell_flux: the part of its vertices' flux that a cell takes, 0 where there is
// none.
Bool is_cell(Vec4 flux_texel) { return flux_texel.w > 0.0f; }
