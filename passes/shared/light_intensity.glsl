// A light's falloff from its axis. Of a spot light (KHR_lights_punctual): 1 inside the inner cone, 0 outside
// the outer, the square of a linear ramp of the cosine between. Of a Lambertian emitter: the cosine itself.
// Expects the uniforms cone and cone_axis.
Float cone_falloff(Vec3 direction) {
  Float falloff = Float(1.0f);
  if (u.cone.x != 0.0f) {
    Float ramp = clamp_to(dot3(direction, Vec3(u.cone_axis)) * u.cone.x + u.cone.y, 0.0f, 1.0f);
    falloff = ramp * ramp;
    if (u.cone.z != 0.0f) falloff = ramp;
  }
  return falloff;
}
