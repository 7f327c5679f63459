// A light's falloff from its axis. Of a spot light (KHR_lights_punctual): 1 inside the inner cone, 0 outside
// the outer, the square of a linear ramp of the cosine between. Of a Lambertian emitter: the cosine itself.
// 1 - cos is half the square of the difference of both unit vectors, which keeps its digits in narrow cones.
// Expects the uniforms cone and cone_axis.
Float cone_falloff(Vec3 direction) {
  Float falloff = Float(1.0f);
  if (u.cone.z != 0.0f) {
    falloff = clamp_to(dot3(direction, Vec3(u.cone_axis)), 0.0f, 1.0f);
  } else if (u.cone.x != 0.0f) {
    Vec3 off = direction - Vec3(u.cone_axis);
    Float ramp = clamp_to(Float(u.cone.y) - dot3(off, off) * (0.5f * u.cone.x), 0.0f, 1.0f);
    falloff = ramp * ramp;
  }
  return falloff;
}
