// Roughness changes how a surface bends and spreads light. Needs microfacets.glsl,
// surface.glsl, and the uniform rough_from.

// The width of the slopes of rough glass' microfacets; 0: the surface is smooth.
Float width_of_facets(IN(Material) material, IN(Meeting) at) {
  Bool rough = material.roughness > u.rough_from && !material.mirror && !at.hole;
  return sel(rough, material.roughness * material.roughness, Float(0.0f));
}

// Makes the surface a rough wall without thickness, which light passes straight, spread by its facets.
void make_wall(INOUT(Surface) surface, IN(Material) material, Vec3 direction, Vec3 normal) {
  Refraction wall = through_wall(direction, normal, surface.normal, material.ior);
  Bool thin = material.thin && !surface.both.passes;
  surface.bent = either(thin, wall, surface.bent);
  surface.eta = sel(thin, Float(1.0f), surface.eta);
  surface.total = surface.total && !thin;
  surface.one_way = surface.one_way && !thin;
  surface.mirrored = sel(thin, wall.reflectance * material.fresnel, surface.mirrored);
}
