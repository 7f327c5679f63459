// Rough glass: the lean of its microfacets, GGX (Walter, Marschner, Li, Torrance 2007). Needs
// axes_across.glsl.

// A triangle wave of period 1, between 0 and 1: as even as what it is of.
Float folded(Float x) { return 1.0f - abs((x - floor(x)) * 2.0f - 1.0f); }

// A sine of period 1 but for a few percent, made of two parabolas.
Float wave(Float x) {
  Float t = (x - floor(x)) * 2.0f;
  Float above = t * (1.0f - t);
  Float below = (t - 1.0f) * (t - 2.0f);
  return sel(t < 1.0f, above, below);
}

// A slope of width 1: `share` of all are less steep, the steepest 5 % taken for the least of them; `turn`:
// which way, 0..1.
Vec2 facet_slope(Float share, Float turn) {
  Float s = min_of(share, 0.95f);
  Float steepness = sqrt(s / (1.0f - s));
  Vec2 way = Vec2(wave(turn + 0.25f), wave(turn));
  return way * (steepness / sqrt(dot2(way, way)));
}

// n: unit. A slope of 0 leaves it as it is, but for rounding.
Vec3 facet_normal(Vec3 n, Vec2 slope) {
  AxesAcross axes = axes_across(n);
  return normalize_or(n + axes.x * slope.x + axes.y * slope.y, n);
}
