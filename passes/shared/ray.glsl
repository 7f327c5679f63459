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

// Of the up to four bodies that light, or sight, is in (media.glsl).
Bool is_in_body(Vec4 media, Float body) {
  return media.x == body || media.y == body || media.z == body || media.w == body;
}
