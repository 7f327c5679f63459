// Needs ray.glsl, and the uniforms receivers_lower and receivers_upper: the box around all receivers.

Float inverse(Float x) {
  return sel(abs(x) > 1.0e-20f, 1.0f / sel(x != 0.0f, x, Float(1.0f)), Float(1.0e20f));
}

// Where a ray, from its start on, crosses the box around all receivers: distances along it, metres.
struct Crossing {
  Bool meets;
  Float enters;
  Float leaves;
};

// Slabs: Kay and Kajiya 1986.
Crossing cross_receivers(IN(Ray) ray) {
  Vec3 per = Vec3(inverse(ray.direction.x), inverse(ray.direction.y), inverse(ray.direction.z));
  Vec3 a = (Vec3(u.receivers_lower) - ray.start) * per;
  Vec3 b = (Vec3(u.receivers_upper) - ray.start) * per;
  Crossing box;
  box.enters = max_of(max_of(min_of(a.x, b.x), min_of(a.y, b.y)), max_of(min_of(a.z, b.z), Float(0.0f)));
  box.leaves = min_of(min_of(max_of(a.x, b.x), max_of(a.y, b.y)), max_of(a.z, b.z));
  box.meets = box.leaves >= box.enters;
  return box;
}
