// Which part of a ray a light with a position reaches at all: its cone and its range, in closed form. Needs
// ray.glsl.

Float away_from_zero(Float x) { return sel(x < 0.0f, min_of(x, Float(-1.0e-20f)), max_of(x, 1.0e-20f)); }

Vec2 narrowed(Vec2 range, Float lower, Float upper) {
  return Vec2(max_of(range.x, lower), min_of(range.y, upper));
}

// Where a ray, from a point relative to the light, is before the plane across the light's axis.
Vec2 before_light(Vec2 range, Float z, Float dz) {
  Float at = -z / away_from_zero(dz);
  Float far = Float(1.0e30f);
  return narrowed(range, sel(dz >= 0.0f, at, -far), sel(dz >= 0.0f, far, at));
}

// Where a ray is within the cone around the light's axis whose slope's square is given: a quadratic in the
// way along the ray, counted from where it passes the axis, which keeps the digits of a narrow cone.
Vec2 within_cone(Vec2 range, Vec3 from_light, Vec3 direction, float slope_squared) {
  Vec3 axis = Vec3(u.light.cone.axis);
  Float dz = dot3(direction, axis);
  Vec3 d = direction - axis * dz;
  Float across = dot3(d, d);
  Float z_start = dot3(from_light, axis);
  Vec3 p_start = from_light - axis * z_start;
  Float passes = sel(across > 1.0e-12f, -dot3(p_start, d) / max_of(across, 1.0e-12f), Float(0.0f));
  Vec3 p = p_start + d * passes;
  Float z = z_start + dz * passes;

  Float a = across - slope_squared * (dz * dz);
  Float b = dot3(p, d) - slope_squared * (z * dz);
  Float c = dot3(p, p) - slope_squared * (z * z);
  Float discriminant = b * b - a * c;
  Float root = sqrt(max_of(discriminant, 0.0f));
  Float sum = -(b + sel(b < 0.0f, -root, root));
  Float first = sum / away_from_zero(a);
  Float second = c / away_from_zero(sum);
  Float lower = min_of(first, second);
  Float upper = max_of(first, second);

  // Flatter than the cone the ray crosses one nappe twice, or none. Else it crosses each once, and stays in
  // the one towards which it goes.
  Bool flat_ray = a > 0.0f;
  Bool met = discriminant > 0.0f && z + dz * ((lower + upper) * 0.5f) > 0.0f;
  Float far = Float(1.0e30f);
  Float from = sel(flat_ray, sel(met, lower, far), sel(dz > 0.0f, upper, -far));
  Float to = sel(flat_ray, sel(met, upper, -far), sel(dz > 0.0f, far, lower));
  return narrowed(range, passes + from, passes + to);
}

Vec2 reached_by_light(Vec2 range, IN(Ray) ray) {
  Vec2 reached = range;
  Vec3 from_light = ray.start - Vec3(u.light.position);
  if (u.light.range > 0.0f) {
    Float nearest = -dot3(from_light, ray.direction);
    Vec3 miss = from_light + ray.direction * nearest;
    Float half_chord = sqrt(max_of(u.light.range * u.light.range - dot3(miss, miss), 0.0f));
    reached = narrowed(reached, nearest - half_chord, nearest + half_chord);
  }
  if (u.light.cone.lambertian != 0 || u.light.cone.scale != 0.0f) {
    Vec3 axis = Vec3(u.light.cone.axis);
    reached = before_light(reached, dot3(from_light, axis), dot3(ray.direction, axis));
  }
  if (u.light.cone.lambertian == 0 && u.light.cone.scale != 0.0f) {
    float edge = u.light.cone.offset / u.light.cone.scale;  // 1 - cos
    // Wider than 87 degrees the plane is as near.
    if (edge < 0.95f) {
      float slope_squared = edge * (2.0f - edge) / ((1.0f - edge) * (1.0f - edge));
      reached = within_cone(reached, from_light, ray.direction, slope_squared);
    }
  }
  return reached;
}
