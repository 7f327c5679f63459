// A light as it would arrive at a surface with nothing on its way. Needs cone_falloff.glsl,
// light_falloff.glsl.
struct Incidence {
  Vec3 at;                 // the surface's point, scene space
  Vec3 travel;             // the way it goes, unit, scene space
  Float distance_squared;  // from a light with a position, else 1
  Float spread;            // square metres that a candela is spread over: the same, bounded near the light
  Float falloff;           // what is left of its intensity here
  Float facing;            // cosine between its way and the surface's normal; 0 from behind
};

// Nearer to a Lambertian emitter's plane than this share of its radius counts as on it.
#define OWN_PLANE 1.0e-3f

// The sine of half the angle that a Lambertian emitter's disk fills, near enough: by it a mirror image is
// spread, so that it is never brighter than the emitter (Karis, Real Shading in Unreal Engine 4, 2013).
Float half_width(IN(Light) source, IN(Incidence) light) {
  Float size = Float(0.0f);
  if (source.cone.lambertian != 0) size = source.radius * 0.5f / sqrt(light.spread);
  return size;
}

Incidence incidence_of(IN(Light) source, Vec3 position, Vec3 normal) {
  Incidence light;
  light.at = position;
  light.travel = Vec3(source.direction);
  light.falloff = Float(1.0f);
  light.distance_squared = Float(1.0f);
  light.spread = Float(1.0f);
  if (source.has_position != 0) {
    Vec3 path = position - Vec3(source.position);
    light.distance_squared = max_of(dot3(path, path), 1.0e-20f);
    light.travel = normalize_or(path, Vec3(source.cone.axis));
    light.falloff = light_falloff(source, light.travel, light.distance_squared);
    float area = source.radius * source.radius;
    light.spread = max_of(light.distance_squared, Float(area));
    if (source.cone.lambertian != 0) {
      // The emitter is a disk, to the second order of r / d (exact on the axis, to a surface that faces it):
      // its form factor over r^2 cos^2 / d^2 is 1 - (3 cos^2 - 2) r^2 / d^2. It never gives more than pi L,
      // and nothing to its own plane, whatever rounding says.
      Float cosine = dot3(light.travel, Vec3(source.cone.axis));
      light.spread = max_of(light.distance_squared + area * (3.0f * (cosine * cosine) - 2.0f), Float(area));
      Bool before = dot3(path, Vec3(source.cone.axis)) > OWN_PLANE * source.radius;
      light.falloff = sel(before, light.falloff, Float(0.0f));
    }
  }
  light.facing = max_of(-dot3(normal, light.travel), 0.0f);
  return light;
}
