// What the pass view_range writes.
struct ViewRange {
  Float surface_z;  // of the first surface along the camera's axis, metres, 1e30 where there is none
  Float entry;      // distances from the ray's start at which it enters the medium, metres,
  Float exit;       // and leaves it or ends
};

ViewRange fetch_view_range(Texture ranges) {
  Vec4 texel = texel_fetch(ranges, floor_to_int(frag_x()), floor_to_int(frag_y()));
  ViewRange range;
  range.surface_z = texel.x;
  range.entry = texel.y;
  range.exit = texel.z;
  return range;
}
