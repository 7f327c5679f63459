// The camera's ray through this pixel's centre. Expects view_ray_uniforms.glsl.
Vec3 view_ray_offset() {
  return Vec3(u.right) * (frag_x() * u.pixel.x + u.pixel.z) + Vec3(u.up) * (frag_y() * u.pixel.y + u.pixel.w);
}

Vec3 view_ray_origin() {
  Vec3 origin = Vec3(u.eye);
  if (u.eye.w < 0.5f) origin = origin + view_ray_offset();
  return origin;
}

Vec3 view_ray_direction() {
  Vec3 direction = Vec3(u.forward);
  if (u.eye.w > 0.5f) direction = normalize_or(direction + view_ray_offset(), direction);
  return direction;
}
