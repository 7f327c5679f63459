// The camera's ray through this pixel's middle, from the camera or, of parallel rays, from the plane across
// it. Needs ray.glsl.
Ray camera_ray(IN(CameraRays) camera) {
  Float x = frag_x() * camera.pixel.x + camera.corner.x;
  Float y = frag_y() * camera.pixel.y + camera.corner.y;
  Vec3 offset = Vec3(camera.right) * x + Vec3(camera.up) * y;
  Ray ray = ray_from(Vec3(camera.origin), Vec3(camera.forward));
  if (camera.is_perspective != 0) {
    ray.direction = normalize_or(ray.direction + offset, ray.direction);
  } else {
    ray.start = ray.start + offset;
  }
  return ray;
}
