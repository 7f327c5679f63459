// Haze that fills a box, outside of glass (docs/medium.md). Expects medium_uniforms.glsl and optics.glsl.

// How far a ray goes along one axis until it leaves the box. One that runs along a face stays inside.
Float slab_exit(Float p, Float d, float lower, float upper) {
  Float reach = sel(d >= 0.0f, upper - p, p - lower);
  Bool moves = abs(d) > 1.0e-12f;
  return sel(moves, max_of(reach, 0.0f) / sel(moves, abs(d), Float(1.0f)), Float(1.0e30f));
}

// How far a ray from inside the box goes until it leaves it, metres.
Float medium_exit(Vec3 p, Vec3 d) {
  return min_of(min_of(slab_exit(p.x, d.x, u.medium_lower.x, u.medium_upper.x),
                       slab_exit(p.y, d.y, u.medium_lower.y, u.medium_upper.y)),
                slab_exit(p.z, d.z, u.medium_lower.z, u.medium_upper.z));
}

// How far light has come through the medium to p: from where it enters the box, or from its position, which lies
// in the box.
Float light_way(Vec3 p, Vec3 travel, Vec3 light, bool positional) {
  Float way = Float(0.0f);
  if (positional) {
    way = length3(p - light);
  } else {
    way = medium_exit(p, -travel);
  }
  return way;
}

// Transmittance over a length, one exponential where all channels are alike.
Vec3 medium_transmittance(Float metres) {
  Vec3 result = Vec3(0.0f);
  if (u.medium_upper.w > 0.5f) {
    result = Vec3(exp_of(-(u.extinction.x * max_of(metres, 0.0f))));
  } else {
    result = transmittance(Vec3(u.extinction), metres);
  }
  return result;
}

// Share of scattered light per steradian in the direction at an angle of this cosine to the light's way: Henyey and
// Greenstein 1941. 1 / (4 pi) for anisotropy 0.
Float phase_function(Float cosine) {
  float g = u.medium_lower.w;
  float k = (1.0f - g * g) * 0.0795774715f;
  float sum = 1.0f + g * g;
  float twice = 2.0f * g;
  Float base = max_of(sum - twice * cosine, 1.0e-6f);
  return k / (base * sqrt(base));
}
