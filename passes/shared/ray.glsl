// A ray of light, of a camera, or of what looks for a surface.
struct Ray {
  Vec3 start;
  Vec3 direction;  // unit
};

Vec3 point_along(Ray ray, Float distance) { return ray.start + ray.direction * distance; }

Ray ray_from(Vec3 start, Vec3 direction) {
  Ray ray;
  ray.start = start;
  ray.direction = direction;
  return ray;
}
