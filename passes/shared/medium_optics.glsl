// What a medium does to light (docs/medium.md). Needs optics.glsl and ray.glsl.

// How far a ray goes along one axis until it leaves the box. One that runs along a face stays inside.
Float slab_exit(Float p, Float d, float lower, float upper) {
  Float reach = sel(d >= 0.0f, upper - p, p - lower);
  Bool moves = abs(d) > 1.0e-12f;
  return sel(moves, max_of(reach, 0.0f) / sel(moves, abs(d), Float(1.0f)), Float(1.0e30f));
}

// How far a ray from inside the box goes until it leaves it, metres.
Float medium_exit(IN(Medium) medium, IN(Ray) ray) {
  return min_of(min_of(slab_exit(ray.start.x, ray.direction.x, medium.lower.x, medium.upper.x),
                       slab_exit(ray.start.y, ray.direction.y, medium.lower.y, medium.upper.y)),
                slab_exit(ray.start.z, ray.direction.z, medium.lower.z, medium.upper.z));
}

// Transmittance over a length, one exponential where all channels are alike.
Vec3 medium_transmittance(IN(Medium) medium, Float metres) {
  Vec3 result = Vec3(0.0f);
  if (medium.is_grey != 0) {
    result = Vec3(exp_of(-(medium.extinction.x * max_of(metres, 0.0f))));
  } else {
    result = transmittance(Vec3(medium.extinction), metres);
  }
  return result;
}

// Share of scattered light per steradian in the direction at an angle of this cosine to the light's way:
// Henyey and Greenstein 1941. 1 / (4 pi) for anisotropy 0.
Float phase_function(IN(Medium) medium, Float cosine) {
  float g = medium.anisotropy;
  float k = (1.0f - g * g) * 0.0795774715f;
  float sum = 1.0f + g * g;
  float twice = 2.0f * g;
  Float base = max_of(sum - twice * cosine, 1.0e-6f);
  return k / (base * sqrt(base));
}
