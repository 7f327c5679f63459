// What a caustic is averaged over for a pixel. Needs caustic_lookup.glsl.

// Half of each side to either side of the point, in view coordinates, and by how many samples along each.
struct Footprint {
  Vec3 across;
  Vec3 upward;
  Float columns;
  Float rows;
  Bool in_map;  // any of it
};

// The step to a neighbouring pixel in view coordinates; none where that pixel shows something else.
Vec3 step_on_surface(IN(SurfacePoint) surface, int dx, int dy) {
  Vec3 offset = offset_to_neighbour(view_position, surface, dx, dy);
  Float off_plane = dot3(offset, surface.normal);
  Bool same = off_plane * off_plane <= 0.25f * dot3(offset, offset);
  return sel(same, transform_vector(u.caustic_view.from_scene, offset), Vec3(0.0f));
}

// The larger side in a map of a step from a point, texels of the face that sees the point; 0 where the step
// ends behind the light.
Float texels_along(IN(View) view, Vec3 at, Vec3 step) {
  Int face = view_face(view, at);
  Vec3 from = in_face(view, at, face);
  Vec3 to = in_face(view, at + step, face);
  Float texels;
  if (view.kind == VIEW_PARALLEL) {
    texels = max_of(abs(to.x - from.x) * view.scale.x, abs(to.y - from.y) * view.scale.y);
  } else {
    Bool before = from.z > 0.0f && to.z > 0.0f;
    Float near = sel(before, from.z, Float(1.0f));
    Float far = sel(before, to.z, Float(1.0f));
    texels = sel(before, max_of(abs(to.x / far - from.x / near) * view.scale.x,
                                abs(to.y / far - from.y / near) * view.scale.y),
                 Float(0.0f));
  }
  return min_of(texels * u.caustic_side, Float(16384.0f));
}

// How much of a pixel's side of so many texels is averaged over: a texel is already the mean over itself, and
// one interpolated value is spread as widely as a pixel of sqrt 3 texels.
Float spread_of(Float texels) {
  return sel(texels * texels > 3.0f, sqrt(max_of(texels * texels - 1.0f, 0.0f)), Float(0.0f));
}

// A sample for each texel of the side.
Float samples_over(Float spread, Float texels) {
  Float whole = Float(floor_to_int(texels));
  Float count = sel(whole < texels, whole + 1.0f, whole);
  return clamp_to(sel(spread > 0.0f, count, Float(1.0f)), 1.0f, float(u.samples_across));
}

// Of a point that `receives`; the others, and those whose pixel lies beside the map, count once.
Footprint footprint_at(IN(SurfacePoint) surface, Vec3 at, Bool receives) {
  Footprint f;
  f.across = step_on_surface(surface, 1, 0);
  f.upward = step_on_surface(surface, 0, 1);
  Float columns = texels_along(u.caustic_view, at, f.across);
  Float rows = texels_along(u.caustic_view, at, f.upward);
  Bool finer = Bool(false);
  if (u.has_cascade != 0) {
    Float finer_columns = texels_along(u.cascade_view, at, f.across);
    Float finer_rows = texels_along(u.cascade_view, at, f.upward);
    Float half_pixel = (finer_columns + finer_rows) * 0.5f / u.caustic_side;
    finer = is_near_cascade(at, Vec2(half_pixel, half_pixel));
    columns = sel(finer, finer_columns, columns);
    rows = sel(finer, finer_rows, rows);
  }
  Vec2 uv = view_uv(u.caustic_view, at);
  Float reach = (columns + rows) / u.caustic_side;
  Bool counts = receives && uv.x > -reach && uv.y > -reach && uv.x < reach + 1.0f && uv.y < reach + 1.0f;
  Float wide = sel(counts, spread_of(columns), Float(0.0f));
  Float high = sel(counts, spread_of(rows), Float(0.0f));
  f.across = f.across * (wide / max_of(columns, 1.0f));
  f.upward = f.upward * (high / max_of(rows, 1.0f));
  f.columns = samples_over(wide, columns);
  f.rows = samples_over(high, rows);
  f.in_map = counts || (receives && finer);
  return f;
}
