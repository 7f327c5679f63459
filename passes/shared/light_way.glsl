// How far light has come through the medium to p: from where it enters the box, or from its position, which
// lies in the box. Needs medium_optics.glsl.
Float light_way(IN(Medium) medium, IN(Light) light, Vec3 p) {
  Float way = Float(0.0f);
  if (light.has_position != 0) {
    way = length3(p - Vec3(light.position));
  } else {
    way = medium_exit(medium, ray_from(p, -Vec3(light.direction)));
  }
  return way;
}
