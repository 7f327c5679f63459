// A neighbour's offset from the point at (x, y), one pixel along (dx, dy) or against it, whichever lies
// nearer, because that one is more likely to lie on the same triangle. Zero where neither is a surface.
Vec3 offset_to_neighbour(Texture positions, Int x, Int y, int dx, int dy, Vec3 p) {
  Vec4 ahead = fetch_clamped(positions, x + dx, y + dy);
  Vec4 behind = fetch_clamped(positions, x - dx, y - dy);
  Vec3 forth = Vec3(ahead) - p;
  Vec3 back = p - Vec3(behind);
  // Beyond the picture's edge the clamped texel is the point itself: length zero, as where nothing is seen.
  Float forth_squared = sel(ahead.w != 0.0f, dot3(forth, forth), Float(0.0f));
  Float back_squared = sel(behind.w != 0.0f, dot3(back, back), Float(0.0f));
  Bool takes_forth = forth_squared > 0.0f && (forth_squared <= back_squared || back_squared == 0.0f);
  return sel(takes_forth, forth, sel(back_squared > 0.0f, back, Vec3(0.0f)));
}

// The normal of the triangle that a picture of positions shows at (x, y), on either side of it: across the
// neighbouring pixels' positions. `otherwise` where they are no two directions.
Vec3 plane_normal(Texture positions, Int x, Int y, Vec3 p, Vec3 otherwise) {
  Vec3 across = offset_to_neighbour(positions, x, y, 1, 0, p);
  Vec3 upward = offset_to_neighbour(positions, x, y, 0, 1, p);
  // Unit vectors first: a pixel's extent, squared twice, may be too small for normalize_or.
  Vec3 none = Vec3(0.0f);
  Vec3 normal = cross3(normalize_or(across, none), normalize_or(upward, none));
  // Two offsets within a thousandth of one line are rounding, not a plane.
  return sel(dot3(normal, normal) > 1.0e-6f, normalize_or(normal, otherwise), otherwise);
}
