// What is left of the intensity of a light with a position: its cone's falloff in a direction of travel, and
// KHR_lights_punctual's window over its range, 1 - (d / range)^4, clamped. Needs cone_falloff.glsl.
Float light_falloff(IN(Light) light, Vec3 direction, Float distance_squared) {
  Float falloff = cone_falloff(light.cone, direction);
  if (light.range > 0.0f) {
    Float s = distance_squared / (light.range * light.range);
    falloff = falloff * clamp_to(1.0f - s * s, 0.0f, 1.0f);
  }
  return falloff;
}
