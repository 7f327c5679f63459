// A beam's image in the picture: a line between two ends. Needs view_space.glsl and light_shafts.glsl's
// pixel_of.

// The line is followed along the picture's x or y, from its lower end to its upper one.
struct Line {
  Bool follows_y;
  Vec2 lower;        // the ends, pixels
  Vec2 upper;
  Vec2 at;           // of the lower and the upper end: distance from the beam's start, metres,
  Vec2 w;            // and what window coordinates are divided by
  Bool has_extent;
  Float slope;       // pixels across a pixel along; 0 without extent
};

Float along(IN(Line) line, Vec2 p) { return sel(line.follows_y, p.y, p.x); }
Float across(IN(Line) line, Vec2 p) { return sel(line.follows_y, p.x, p.y); }

// Narrows a range of distances to where at + slope * distance >= 0.
Vec2 clipped(Vec2 range, Float at, Float slope) {
  Float root = -at / sel(slope != 0.0f, slope, Float(1.0f));
  Float from = sel(slope > 0.0f, max_of(range.x, root), range.x);
  Float to = sel(slope < 0.0f, min_of(range.y, root), range.y);
  return Vec2(from, sel(slope == 0.0f && at < 0.0f, Float(-1.0f), to));
}

// The part of a beam, from q along d, that lies before the camera and within the picture with a margin of the
// widest beam.
Vec2 in_view(Vec3 q, Vec3 d, Float length) {
  float left = -(u.widest / u.picture.x);
  float bottom = -(u.widest / u.picture.y);
  Vec2 range = clipped(Vec2(Float(0.0f), length), q.z - u.view.near, d.z);
  Float w0 = Float(1.0f);
  Float w1 = Float(0.0f);
  if (u.view.kind != VIEW_PARALLEL) {
    w0 = q.z;
    w1 = d.z;
  }
  Float u0 = q.x * u.view.scale.x + u.view.offset.x * w0;
  Float u1 = d.x * u.view.scale.x + u.view.offset.x * w1;
  Float v0 = q.y * u.view.scale.y + u.view.offset.y * w0;
  Float v1 = d.y * u.view.scale.y + u.view.offset.y * w1;
  range = clipped(range, u0 - left * w0, u1 - left * w1);
  range = clipped(range, (1.0f - left) * w0 - u0, (1.0f - left) * w1 - u1);
  range = clipped(range, v0 - bottom * w0, v1 - bottom * w1);
  return clipped(range, (1.0f - bottom) * w0 - v0, (1.0f - bottom) * w1 - v1);
}

// A point before the camera, if need be moved there.
Vec3 before_camera(Vec3 q) { return Vec3(q.x, q.y, max_of(q.z, max_of(Float(u.view.near), 1.0e-6f))); }

// The image of a beam between two distances from its start, in the camera's view.
Line image_of(Vec3 q, Vec3 d, Vec2 range) {
  Vec3 near = before_camera(q + d * range.x);
  Vec3 far = before_camera(q + d * range.y);
  Vec2 a = pixel_of(near);
  Vec2 b = pixel_of(far);
  Line line;
  line.follows_y = abs(b.y - a.y) > abs(b.x - a.x);
  Bool swapped = along(line, a) > along(line, b);
  line.lower = sel(swapped, b, a);
  line.upper = sel(swapped, a, b);
  line.at = sel(swapped, Vec2(range.y, range.x), range);
  line.w = Vec2(view_w(u.view, sel(swapped, far, near)), view_w(u.view, sel(swapped, near, far)));
  Float extent = along(line, line.upper) - along(line, line.lower);
  Float rise = across(line, line.upper) - across(line, line.lower);
  line.has_extent = extent > 0.01f;
  line.slope = sel(line.has_extent, rise / sel(line.has_extent, extent, Float(1.0f)), Float(0.0f));
  return line;
}

// How far across a point lies from the line through one of its ends, pixels.
Float beside_end(IN(Line) line, Vec2 end, Vec2 p) {
  return across(line, p) - across(line, end) - line.slope * (along(line, p) - along(line, end));
}

// How far a neighbouring beam runs beside the line at the ends' distances from the starts, across, in pixels
// times w.
Vec2 beside(IN(Line) line, Int column, Int row) {
  Vec3 other = view_coordinates(u.view, Vec3(fetch_clamped(beam_start, column, row)));
  Vec3 heading = transform_vector(u.view.from_scene, Vec3(fetch_clamped(beam_way, column, row)));
  Vec2 a = pixel_of(before_camera(other + heading * line.at.x));
  Vec2 b = pixel_of(before_camera(other + heading * line.at.y));
  return Vec2(beside_end(line, line.lower, a) * line.w.x, beside_end(line, line.upper, b) * line.w.y);
}

Bool is_beam(Int column, Int row) {
  Bool in_grid = column >= 0 && row >= 0 && column < u.beams_a_side && row < u.beams_a_side;
  Float leaves = fetch_clamped(beam_way, column, row).w;
  return in_grid && leaves != 0.0f;
}

Float reach(Vec2 offsets) { return max_of(abs(offsets.x), abs(offsets.y)); }

// Of the neighbours on both sides the nearer, which is more likely to be of the same sheet of light.
Vec2 nearer_beside(IN(Line) line, Int x, Int y, int dx, int dy) {
  Bool ahead = is_beam(x + dx, y + dy);
  Bool behind = is_beam(x - dx, y - dy);
  Vec2 a = beside(line, x + dx, y + dy);
  Vec2 b = beside(line, x - dx, y - dy);
  Bool takes = ahead && (!behind || reach(a) <= reach(b));
  return sel(takes, a, sel(behind, b, Vec2(0.0f)));
}

// Half the beam's width at its lower and its upper end, pixels, where it is as wide as its offsets to a
// neighbour in the grid's rows and one in its columns: the foot of share_below's trapezoid.
Vec2 feet_of(IN(Line) line, Vec2 rows, Vec2 columns) {
  return Vec2((beam_width(rows.x, line.w.x) + beam_width(columns.x, line.w.x)) * 0.5f,
              (beam_width(rows.y, line.w.y) + beam_width(columns.y, line.w.y)) * 0.5f);
}

// Where a corner of the beam's two triangles is drawn, pixels. They are a trapezium over whole pixels along
// the beam. Across it reaches a pixel beyond the beam's foot: half a pixel for the pixels' own width, half
// for the ends, where the middle of what a pixel holds of the beam is not the pixel's.
Vec2 corner_of(IN(Line) line, Vec2 feet, Int corner) {
  Float low = along(line, line.lower);
  Float high = along(line, line.upper);
  // Offsets change linearly along the picture, so between the ends a foot is no wider than the line between
  // its ends, unless an end has been limited.
  Float widest = max_of(feet.x, feet.y);
  Bool limited = widest > u.widest * 0.5f;
  Bool at_high = corner == 1 || corner == 2 || corner == 4;
  Bool above = corner == 2 || corner == 4 || corner == 5;
  Float m = sel(at_high, floor(high) + 1.0f, floor(low));
  // A beam across whose ends the trapezium goes on to whole pixels gets the wider foot if it is short.
  Float half_width = sel(limited || high - low < 4.0f, widest, sel(at_high, feet.y, feet.x)) + 1.0f +
                     sel(line.has_extent, abs(feet.y - feet.x) / max_of(high - low, 4.0f), Float(0.0f));
  Float n = across(line, line.lower) + line.slope * (m - low) + sel(above, half_width, -half_width);
  return Vec2(sel(line.follows_y, n, m), sel(line.follows_y, m, n));
}
