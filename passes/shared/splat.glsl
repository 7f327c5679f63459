// Where a point is drawn: at its place while its centre is on the map, else outside of all planes. Of points that
// reach over the edge some drivers clip those whose centre is beyond it and others only what is, so none is left to them.
Vec4 splat_position(Vec4 at, Bool drawn) {
  Bool on_map = abs(at.x) <= 1.0f && abs(at.y) <= 1.0f;
  return sel(drawn && on_map, at, Vec4(2.0f, 2.0f, 2.0f, 1.0f));
}
