// How sure a point of a coarse picture lies on the surface of a point with this normal, 0 to 1: by how little
// it rises over the tangent plane, of its distance. Hardly on another, so that a pixel none of whose
// neighbours are its own gets their mean.
Float same_surface(Vec3 position, Vec3 normal, Vec4 other) {
  Vec3 way = Vec3(other) - position;
  Float rise = abs(dot3(way, normal));
  Float distance = length3(way);
  Float same = max_of(1.0f - 4.0f * (rise / max_of(distance, 1.0e-20f)), 1.0e-4f);
  return sel(is_covered(other), same, Float(0.0f));
}
