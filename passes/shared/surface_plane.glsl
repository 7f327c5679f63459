// The surface that a pixel shows.
struct SurfacePoint {
  Int column;     // the pixel's
  Int row;
  Bool visible;   // there is a surface
  Vec3 position;  // scene space
  Vec3 normal;    // its shading normal, unit
};

// A neighbour's offset from a point, one pixel along (dx, dy) or against it, whichever lies nearer, because
// that one is more likely to lie on the same triangle. Zero where neither is a surface.
Vec3 offset_to_neighbour(Texture positions, IN(SurfacePoint) s, int dx, int dy) {
  Vec4 ahead = fetch_clamped(positions, s.column + dx, s.row + dy);
  Vec4 behind = fetch_clamped(positions, s.column - dx, s.row - dy);
  Vec3 forth = Vec3(ahead) - s.position;
  Vec3 back = s.position - Vec3(behind);
  // Beyond the picture's edge the clamped texel is the point itself: length zero, as where nothing is seen.
  Float forth_squared = sel(is_covered(ahead), dot3(forth, forth), Float(0.0f));
  Float back_squared = sel(is_covered(behind), dot3(back, back), Float(0.0f));
  Bool takes_forth = forth_squared > 0.0f && (forth_squared <= back_squared || back_squared == 0.0f);
  return sel(takes_forth, forth, sel(back_squared > 0.0f, back, Vec3(0.0f)));
}

// The normal of the triangle that a picture of positions shows at a point, on either side of it: across the
// neighbouring pixels' positions. The shading normal where they are no two directions.
Vec3 plane_normal(Texture positions, IN(SurfacePoint) s) {
  Vec3 across = offset_to_neighbour(positions, s, 1, 0);
  Vec3 upward = offset_to_neighbour(positions, s, 0, 1);
  // Unit vectors first: a pixel's extent, squared twice, may be too small for normalize_or.
  Vec3 none = Vec3(0.0f);
  Vec3 normal = cross3(normalize_or(across, none), normalize_or(upward, none));
  // Two offsets within a thousandth of one line are rounding, not a plane.
  return sel(dot3(normal, normal) > 1.0e-6f, normalize_or(normal, s.normal), s.normal);
}
