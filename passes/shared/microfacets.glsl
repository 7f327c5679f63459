// Rough glass: the lean of its microfacets, GGX (Walter, Marschner, Li, Torrance 2007). Needs
// axes_across.glsl, caster_material.glsl, refraction.glsl.

// A triangle wave of period 1, between 0 and 1: as even as what it is of.
Float folded(Float x) { return 1.0f - abs((x - floor(x)) * 2.0f - 1.0f); }

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

// Light along d at a rough wall without thickness: what passes leaves as its facet would mirror it, on the
// other side (glTF, KHR_materials_transmission); both faces together mirror 2 r / (1 + r). n, facet: unit,
// against d.
Refraction through_wall(Vec3 d, Vec3 n, Vec3 facet, Float ior) {
  Refraction r = refraction_at(d, facet, 1.0f / ior);
  Vec3 mirrored = reflected(d, facet, r.cosine);
  Float across = dot3(mirrored, n);
  r.direction = normalize_or(mirrored - n * (across + abs(across)), d);
  r.total = Bool(false);
  return r;
}

// A closed body of rough walls tints what passes at both of them; solid glass once.
Vec3 wall_tint(IN(Material) material, Vec3 color, Bool from_inside) {
  return sel(material.thin && material.solid && !from_inside, color * color, color);
}

Refraction either(Bool first, IN(Refraction) a, IN(Refraction) b) {
  Refraction r;
  r.cosine = sel(first, a.cosine, b.cosine);
  r.total = (first && a.total) || (!first && b.total);
  r.direction = sel(first, a.direction, b.direction);
  r.reflectance = sel(first, a.reflectance, b.reflectance);
  return r;
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
