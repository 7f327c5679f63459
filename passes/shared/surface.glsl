// What a caster's surface does to light and to rays of sight: how much of what comes it mirrors, how much it
// lets through, where to, and in which colour. Needs caster_material.glsl, meeting.glsl, optics.glsl
// and refraction.glsl, and the uniform has_walls.
struct Surface {
  Interface both;
  Vec3 normal;     // smooth, against the ray
  Float eta;       // index before the surface over that behind it
  Refraction bent;
  Bool total;      // nothing comes through, though the surface would let it
  Bool one_way;    // all that comes takes the same way
  Float mirrored;  // share of what comes, where there are two ways
};

Surface surface_at(Vec3 direction, IN(Meeting) at, IN(Interface) both, IN(Material) material) {
  Surface surface;
  surface.both = both;
  surface.normal = facing_normal(at.outward, direction, !at.front);
  surface.eta = both.before / both.behind;
  surface.bent = refraction_at(direction, surface.normal, surface.eta);
  surface.total = surface.bent.total && !both.passes && !material.mirror;
  surface.one_way = material.mirror || both.passes || surface.total;
  surface.mirrored = sel(surface.total, Float(1.0f), surface.bent.reflectance * material.fresnel);
  return surface;
}

// Is it mirrored, where the ray takes one way only: that of all light, or else of the most?
Bool most_is_mirrored(IN(Surface) surface, IN(Material) material, Bool stronger) {
  return !surface.both.passes && (material.mirror || surface.total || stronger);
}

Vec3 direction_behind(IN(Surface) surface, Vec3 direction, Bool is_mirrored) {
  Vec3 mirrored = reflected(direction, surface.normal, surface.bent.cosine);
  Vec3 onward = sel(is_mirrored, mirrored, surface.bent.direction);
  return sel(surface.both.passes, direction, onward);
}

// The share of each channel that is left on the way that a ray takes: a body tints what enters it, metal what
// it mirrors.
Vec3 color_behind(IN(Surface) surface, IN(Material) material, Bool is_mirrored) {
  Vec3 metal = metal_reflectance(material.color, surface.bent.cosine);
  Bool tints = surface.both.tints && !is_mirrored && !surface.both.passes;
  Vec3 passing = sel(tints, material.color * material.transmitted, Vec3(1.0f));
  if (u.has_walls != 0) {
    // Light that a pane does not cover passes untinted.
    Vec3 left = Vec3(1.0f - material.covers) + passing * (material.covers - surface.mirrored);
    passing = sel(material.blended, left / (1.0f - surface.mirrored), passing);
  }
  return sel(material.mirror, metal, passing);
}
