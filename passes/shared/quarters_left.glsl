// Quarters of a grid vertex's flux that the cells around it have not taken.
Float quarters_left(Int column, Int row) {
  Float quarters = Float(4.0f);
  for (int dy = 0; dy < 2; dy++) {
    for (int dx = 0; dx < 2; dx++) {
      Bool in_grid = column >= dx && row >= dy;
      Float whole = fetch_clamped(cell_flux, column - dx, row - dy).w;
      quarters = sel(in_grid, quarters - whole, quarters);
    }
  }
  return quarters;
}
