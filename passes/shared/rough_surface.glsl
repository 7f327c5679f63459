// Roughness changes how a surface bends and spreads light. Needs microfacets.glsl, smooth_surface.glsl, and
// the uniforms has_rough, has_walls and rough_from.

// The width of the slopes of rough glass' microfacets; 0: the surface is smooth.
Float width_of_facets(IN(Material) material, IN(Meeting) at) {
  Bool rough = material.roughness > u.rough_from && !material.mirror && !at.hole;
  return sel(rough, material.roughness * material.roughness, Float(0.0f));
}

// A surface as light meets it: of rough glass one microfacet.
struct Facet {
  Surface surface;
  Vec3 smooth_normal;  // of what the facet is on, against the light
  Float width;         // of all facets' slopes; 0: smooth
};

// `slope`: how the microfacet leans, of width 1.
Facet facet_at(Vec3 from, IN(Meeting) at, IN(Interface) both, IN(Material) material, Vec2 slope) {
  Facet facet;
  facet.width = Float(0.0f);
  Meeting met = at;
  if (u.has_rough != 0) {
    facet.width = width_of_facets(material, at);
    met.outward = facet_normal(at.outward, slope * facet.width);
  }
  facet.surface = surface_at(from, met, both, material);
  facet.smooth_normal = facet.surface.normal;
  if (u.has_rough != 0) {
    facet.smooth_normal = facing_normal(at.outward, from, !at.front);
  }
  if (u.has_walls != 0) {
    if (any_lane(material.thin)) make_wall(facet.surface, material, from, facet.smooth_normal);
  }
  return facet;
}

// A facet sends on a part of its share. Light that it sends through the surface's wrong side meets another
// facet and counts as masked.
Float sent_by(IN(Facet) facet, IN(Meeting) at, Vec3 from, Vec3 onward, Bool is_mirrored) {
  Float sent = facet_weight(from, onward, facet.smooth_normal, facet.surface.normal, facet.width);
  sent = sel(strays(onward, at, from, is_mirrored), Float(0.0f), sent);
  return sel(facet.width > 0.0f, sent, Float(1.0f));
}
