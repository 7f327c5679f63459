// Where a point is drawn: at its place while its centre is on the map, else outside of all planes. Drivers
// differ in how they clip points over the edge, by their centres or by their texels, so none is left to them.
Vec4 splat_position(Vec4 at, Bool drawn) {
  Bool on_map = abs(at.x) <= 1.0f && abs(at.y) <= 1.0f;
  return sel(drawn && on_map, at, Vec4(2.0f, 2.0f, 2.0f, 1.0f));
}
