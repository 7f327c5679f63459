// What light loses on its way between surfaces. Needs caster_material.glsl, optics.glsl and ray.glsl; with
// HAZE medium_optics.glsl, too.

// Is light in no body? `body`: its row in caster_materials plus 1, of the body that it was last to enter.
Bool is_in_air(Float body) { return body == 0.0f; }

// The share of light that the body leaves over a length in metres.
Vec3 left_by(Float body, Float metres) {
  Material material = fetch_material(caster_materials, floor_to_int(body) - 1);
  return sel(body > 0.0f, transmittance(material.absorption, metres), Vec3(1.0f));
}

// The share that the body leaves, or the air where light is in none.
#ifdef HAZE
Vec3 left_on_way(IN(Ray) ray, Float body, Float metres) {
  Float in_air = min_of(metres, medium_exit(u.medium, ray));
  return sel(is_in_air(body), medium_transmittance(u.medium, in_air), left_by(body, metres));
}
#else
Vec3 left_on_way(IN(Ray) ray, Float body, Float metres) { return left_by(body, metres); }
#endif
