// A light as it would arrive at a surface with nothing on its way. Needs cone_falloff.glsl,
// light_falloff.glsl.
struct Incidence {
  Vec3 at;                 // the surface's point, scene space
  Vec3 travel;             // the way it goes, unit, scene space
  Float distance_squared;  // from a light with a position, else 1
  Float falloff;           // what is left of its intensity here
  Float facing;            // cosine between its way and the surface's normal; 0 from behind
};

Incidence incidence_of(IN(Light) source, Vec3 position, Vec3 normal) {
  Incidence light;
  light.at = position;
  light.travel = Vec3(source.direction);
  light.falloff = Float(1.0f);
  light.distance_squared = Float(1.0f);
  if (source.has_position != 0) {
    Vec3 path = position - Vec3(source.position);
    light.distance_squared = max_of(dot3(path, path), 1.0e-20f);
    light.travel = normalize_or(path, Vec3(source.cone.axis));
    light.falloff = light_falloff(source, light.travel, light.distance_squared);
  }
  light.facing = max_of(-dot3(normal, light.travel), 0.0f);
  return light;
}
