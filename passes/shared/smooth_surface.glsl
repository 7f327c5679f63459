// A surface whose microfacets do not spread what comes: as sight meets it, whose picture is blurred later, as
// light meets it that goes through two surfaces. Needs surface.glsl, and the uniform has_walls.

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

Refraction either(Bool first, IN(Refraction) a, IN(Refraction) b) {
  Refraction r;
  r.cosine = sel(first, a.cosine, b.cosine);
  r.total = (first && a.total) || (!first && b.total);
  r.direction = sel(first, a.direction, b.direction);
  r.reflectance = sel(first, a.reflectance, b.reflectance);
  return r;
}

// Makes the surface a wall without thickness, which light passes straight, spread by its facets.
void make_wall(INOUT(Surface) surface, IN(Material) material, Vec3 direction, Vec3 normal) {
  Refraction wall = through_wall(direction, normal, surface.normal, material.ior);
  Bool thin = material.thin && !surface.both.passes;
  surface.bent = either(thin, wall, surface.bent);
  surface.eta = sel(thin, Float(1.0f), surface.eta);
  surface.total = surface.total && !thin;
  surface.one_way = surface.one_way && !thin;
  Float face = surface.bent.reflectance * material.fresnel;
  surface.mirrored = sel(thin, material.covers * (2.0f * face / (1.0f + face)), surface.mirrored);
}

Surface smooth_surface(Vec3 direction, IN(Meeting) at, IN(Interface) both, IN(Material) material) {
  Surface surface = surface_at(direction, at, both, material);
  if (u.has_walls != 0) {
    if (any_lane(material.thin)) make_wall(surface, material, direction, surface.normal);
  }
  return surface;
}
