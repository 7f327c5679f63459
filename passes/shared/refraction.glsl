// Light at a smooth interface: Snell's law and Fresnel's together. Needs optics.glsl.
struct Refraction {
  Float cosine;       // of the angle of incidence
  Bool total;         // total internal reflection: nothing is let through
  Vec3 direction;     // of what is let through
  Float reflectance;  // unpolarised; 1 where the reflection is total
};

// d: unit direction of travel; n: unit normal against it; eta: index where the light comes from over where it
// goes.
Refraction refraction_at(Vec3 d, Vec3 n, Float eta) {
  Refraction r;
  r.cosine = clamp_to(-dot3(d, n), 0.0f, 1.0f);
  Float transmitted_squared = transmitted_cosine_squared(eta, r.cosine);
  r.total = transmitted_squared < 0.0f;
  Float transmitted = sqrt(max_of(transmitted_squared, 0.0f));
  r.direction = refracted(d, n, eta, r.cosine, transmitted);
  r.reflectance = sel(r.total, Float(1.0f), fresnel_reflectance(eta, r.cosine, transmitted));
  return r;
}
