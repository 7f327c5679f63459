// A triangle whose plane holds the view's origin may be interpolated to infinity in a pixel: it is not
// drawn there.
Bool is_edge_on(Vec3 p) {
  return !(abs(p.x) < 1.0e30f && abs(p.y) < 1.0e30f && abs(p.z) < 1.0e30f);
}
