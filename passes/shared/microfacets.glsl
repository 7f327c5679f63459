// Rough glass: the lean of its microfacets, GGX (Walter, Marschner, Li, Torrance 2007). Needs
// axes_across.glsl.

// A sine of period 1 but for a few percent, made of two parabolas.
Float wave(Float x) {
  Float t = (x - floor(x)) * 2.0f;
  Float above = t * (1.0f - t);
  Float below = (t - 1.0f) * (t - 2.0f);
  return sel(t < 1.0f, above, below);
}

// A slope of width 1: `share` of all, less than 1, are less steep; `turn`: which way, 0..1.
Vec2 facet_slope(Float share, Float turn) {
  Float steepness = sqrt(share / (1.0f - share));
  Vec2 way = Vec2(wave(turn + 0.25f), wave(turn));
  return way * (steepness / sqrt(dot2(way, way)));
}

// n: unit. A slope of 0 leaves it as it is, but for rounding.
Vec3 facet_normal(Vec3 n, Vec2 slope) {
  AxesAcross axes = axes_across(n);
  return normalize_or(n + axes.x * slope.x + axes.y * slope.y, n);
}

// Smith's masking for GGX of one direction, whose cosine to the normal is c (Walter et al., eq. 34).
Float unmasked(Float c, Float width) {
  Float squared = max_of(c * c, 1.0e-6f);
  return 2.0f / (1.0f + sqrt(1.0f + width * width * max_of(1.0f - squared, 0.0f) / squared));
}

// What a facet sends from d to o, over its share of all facets' areas seen straight on (eq. 41).
Float facet_weight(Vec3 d, Vec3 o, Vec3 n, Vec3 facet, Float width) {
  Float to_surface = max_of(abs(dot3(d, n)), 1.0e-3f);
  Float leaning = max_of(dot3(facet, n), 1.0e-3f);
  Float to_facet = max_of(-dot3(d, facet), 0.0f);
  return to_facet * unmasked(to_surface, width) * unmasked(abs(dot3(o, n)), width) /
         (to_surface * leaning);
}
