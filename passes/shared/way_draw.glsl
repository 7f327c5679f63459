// Draws which way light takes at a surface that it leaves one way only: a Korobov lattice (Korobov 1959) over
// the grid's vertices and the surfaces in their order, of whole numbers below 4093. Products of two of them
// are exact in single precision. Neighbours draw numbers that lie far apart, so that every few vertices
// together share light out as the surface does.
Float below_4093(Float number) { return number - 4093.0f * floor(number / 4093.0f); }

// Of light that has met no surface.
Float first_draw(Float column, Float row) {
  Float x = below_4093(below_4093(column) * 3681.0f);
  Float y = below_4093(below_4093(row) * 2435.0f);
  return below_4093(x + y);
}

Float next_draw(Float draw) { return below_4093(draw * 1956.0f); }

// Light meets microfacets of rough glass by the same kind of lattice: two numbers a surface. The multipliers
// spread the slopes of 8 x 8 vertices, and of 16 x 16 through two surfaces, about as evenly as any do.
Float first_facet_draw(Float column, Float row) { return below_4093(first_draw(column, row) * 117.0f); }
Float next_facet_draw(Float draw) { return below_4093(draw * 1936.0f); }

// Between 0 and 1.
Float drawn_share(Float draw) { return (draw + 0.5f) * (1.0f / 4093.0f); }

// How often the drawn way parts from the others at the surface of this number behind those where both ways
// are followed. Among the first k it does at k of k + 2 vertices, at each of them about as often.
Float chance_to_part(int surface) { return 1.0f / Float(float((surface > 1 ? surface : 1) + 2)); }
