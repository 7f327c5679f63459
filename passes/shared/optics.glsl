// Refraction and Fresnel at a smooth interface. d: unit direction of travel; n: unit normal against
// it (d.n <= 0); eta = n1/n2, the index where the light comes from over the index where it goes.

// The normal turned against d and, where an interpolated normal faces away from its own surface,
// tilted to just within the horizon.
Vec3 facing_normal(Vec3 n, Vec3 d, Bool flip) {
  Vec3 oriented = sel(flip, -n, n);
  Float along = dot3(oriented, d);
  Vec3 tilted = normalize_or(oriented - d * (along + 1.0e-3f), -d);
  return sel(along < -1.0e-4f, oriented, tilted);
}

// Square of the transmitted ray's cosine, by the form that stays exact near eta = 1 (1 - eta^2 (1 - ci^2)
// cancels there). Negative: total internal reflection.
Float transmitted_cosine_squared(Float eta, Float ci) {
  Float c = (1.0f - eta) * (1.0f + eta) + (eta * ci) * (eta * ci);
  return sel(c < 0.0f && c > -1.0e-6f, Float(0.0f), c);
}

// Snell's law as t = eta d - mu n with mu = (1 - eta)(1 + eta) / (eta ci + ct), which is 0 at eta = 1,
// where the textbook's mu = ct - eta ci loses its digits. ct: the transmitted cosine.
Vec3 refracted(Vec3 d, Vec3 n, Float eta, Float ci, Float ct) {
  Float sum = eta * ci + ct;
  Bool sound = sum > 1.0e-6f;
  Float mu = sel(sound, (1.0f - eta) * (1.0f + eta) / sel(sound, sum, Float(1.0f)), Float(0.0f));
  return normalize_or(d * eta - n * mu, d);
}

Vec3 reflected(Vec3 d, Vec3 n, Float ci) { return normalize_or(d + n * (2.0f * ci), -d); }

// Unpolarised Fresnel reflectance; both interfaces of a solid use it, so polarisation is not carried
// from one to the other.
Float fresnel_reflectance(Float eta, Float ci, Float ct) {
  Float s_sum = eta * ci + ct;
  Float p_sum = eta * ct + ci;
  Bool sound = s_sum > 1.0e-6f && p_sum > 1.0e-6f;
  Float rs = (eta * ci - ct) / sel(sound, s_sum, Float(1.0f));
  Float rp = (eta * ct - ci) / sel(sound, p_sum, Float(1.0f));
  return sel(sound, 0.5f * (rs * rs + rp * rp), sel(eta == 1.0f, Float(0.0f), Float(1.0f)));
}

// Schlick's approximation (1994), as glTF 2.0 has it (appendix B.2).
Vec3 schlick_reflectance(Vec3 normal_incidence, Float grazing_incidence, Float ci) {
  Float s = 1.0f - ci;
  Float grazing = (s * s) * (s * s) * s;
  return normal_incidence * (1.0f - grazing) + Vec3(grazing_incidence * grazing);
}

Vec3 metal_reflectance(Vec3 normal_incidence, Float ci) {
  return schlick_reflectance(normal_incidence, Float(1.0f), ci);
}

// Beer-Lambert transmittance over a length in metres; absorption per metre and channel.
Vec3 transmittance(Vec3 absorption, Float metres) {
  Float d = max_of(metres, 0.0f);
  return Vec3(exp_of(-(absorption.x * d)), exp_of(-(absorption.y * d)),
              exp_of(-(absorption.z * d)));
}
