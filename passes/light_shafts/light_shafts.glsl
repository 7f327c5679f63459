// Draws each beam of a caster's light as what the medium scatters of it towards the camera. light_shafts.md explains.
UNIFORMS_BEGIN
#include "passes/light_shafts/light_shafts_uniforms.glsl"
#include "passes/medium/medium_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, beam_start)
TEXTURE(1, beam_way)
TEXTURE(2, beam_flux)
TEXTURE(3, view_range)
VARYING_FLAT(0, Vec3, start)      // camera's view, metres
VARYING_FLAT(3, Vec3, way)        // likewise, unit
VARYING_FLAT(6, Vec3, flux)
VARYING_FLAT(9, Vec4, ends)       // along the picture's axis that the beam follows: its lower and upper end, pixels,
                                  // and their distances from the beam's start, metres
VARYING_FLAT(13, Vec4, widths)    // across, at the two ends: to a neighbour in the grid's rows, and in its columns,
                                  // pixels times what window coordinates are divided by
VARYING_FLAT(17, Float, follows)  // 0: the picture's x, 1: y
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"

// Pixel coordinates of a point in the camera's view.
Vec2 pixel_of(Vec3 q) {
  Float w = view_w(q, u.depth);
  return Vec2((q.x / w * u.window.x + u.window.z) * u.picture.x, (q.y / w * u.window.y + u.window.w) * u.picture.y);
}

// A beam's width from an offset across: at least a pixel, so that none falls between, and not endless.
Float width(Float offset, Float w) { return clamp_to(abs(offset) / w, 1.0f, u.picture.z); }

#ifdef VERTEX_STAGE

// Narrows a range of distances to where at + slope * distance >= 0.
Vec2 clipped(Vec2 range, Float at, Float slope) {
  Float root = -at / sel(slope != 0.0f, slope, Float(1.0f));
  Float from = sel(slope > 0.0f, max_of(range.x, root), range.x);
  Float to = sel(slope < 0.0f, min_of(range.y, root), range.y);
  return Vec2(from, sel(slope == 0.0f && at < 0.0f, Float(-1.0f), to));
}

// The part of a beam that lies before the camera and within the picture with a margin of the widest beam.
Vec2 in_view(Vec3 q, Vec3 d, Float length) {
  float left = -(u.picture.z / u.picture.x);
  float bottom = -(u.picture.z / u.picture.y);
  Vec2 range = clipped(Vec2(Float(0.0f), length), q.z - u.depth.x, d.z);
  Float w0 = Float(1.0f);
  Float w1 = Float(0.0f);
  if (u.depth.z > 0.5f) {
    w0 = q.z;
    w1 = d.z;
  }
  Float u0 = q.x * u.window.x + u.window.z * w0;
  Float u1 = d.x * u.window.x + u.window.z * w1;
  Float v0 = q.y * u.window.y + u.window.w * w0;
  Float v1 = d.y * u.window.y + u.window.w * w1;
  range = clipped(range, u0 - left * w0, u1 - left * w1);
  range = clipped(range, (1.0f - left) * w0 - u0, (1.0f - left) * w1 - u1);
  range = clipped(range, v0 - bottom * w0, v1 - bottom * w1);
  return clipped(range, (1.0f - bottom) * w0 - v0, (1.0f - bottom) * w1 - v1);
}

// A point before the camera, if need be moved there.
Vec3 before_camera(Vec3 q) { return Vec3(q.x, q.y, max_of(q.z, max_of(Float(u.depth.x), 1.0e-6f))); }

Float along(Vec2 p, Bool follows_y) { return sel(follows_y, p.y, p.x); }
Float across(Vec2 p, Bool follows_y) { return sel(follows_y, p.x, p.y); }

// How far a neighbouring beam runs beside this one at two distances from the starts, across, in pixels times w.
Vec2 beside(Int column, Int row, Vec2 at, Vec2 p, Vec2 q, Float slope, Vec2 w, Bool follows_y) {
  Vec3 other = view_coordinates(u.from_scene, Vec3(fetch_clamped(beam_start, column, row)));
  Vec3 heading = transform_vector(u.from_scene, Vec3(fetch_clamped(beam_way, column, row)));
  Vec2 a = pixel_of(before_camera(other + heading * at.x));
  Vec2 b = pixel_of(before_camera(other + heading * at.y));
  Float first = across(a, follows_y) - across(p, follows_y) - slope * (along(a, follows_y) - along(p, follows_y));
  Float second = across(b, follows_y) - across(q, follows_y) - slope * (along(b, follows_y) - along(q, follows_y));
  return Vec2(first * w.x, second * w.y);
}

Bool is_beam(Int column, Int row) {
  Bool in_grid = column >= 0 && row >= 0 && column < u.beams.x && row < u.beams.x;
  return in_grid && fetch_clamped(beam_way, column, row).w != 0.0f;
}

Float reach(Vec2 offsets) { return max_of(abs(offsets.x), abs(offsets.y)); }

// Of the neighbours on both sides the nearer, which is more likely to be of the same sheet of light.
Vec2 nearer_beside(Int x, Int y, int dx, int dy, Vec2 at, Vec2 p, Vec2 q, Float slope, Vec2 w, Bool follows_y) {
  Bool ahead = is_beam(x + dx, y + dy);
  Bool behind = is_beam(x - dx, y - dy);
  Vec2 a = beside(x + dx, y + dy, at, p, q, slope, w, follows_y);
  Vec2 b = beside(x - dx, y - dy, at, p, q, slope, w, follows_y);
  Bool takes = ahead && (!behind || reach(a) <= reach(b));
  return sel(takes, a, sel(behind, b, Vec2(0.0f)));
}

void main() {
  Int id = vertex_id();
  Int beam = id / 6;
  Int corner = id - beam * 6;
  Int y = beam / Int(u.beams.x);
  Int x = beam - y * Int(u.beams.x);
  Vec4 from = texel_fetch(beam_start, x, y);
  start = view_coordinates(u.from_scene, Vec3(from));
  way = transform_vector(u.from_scene, Vec3(texel_fetch(beam_way, x, y)));
  flux = Vec3(texel_fetch(beam_flux, x, y));
  Vec2 range = in_view(start, way, from.w);
  Bool drawn = is_beam(x, y) && range.y > range.x;

  Vec3 near = before_camera(start + way * range.x);
  Vec3 far = before_camera(start + way * range.y);
  Vec2 a = pixel_of(near);
  Vec2 b = pixel_of(far);
  Bool follows_y = abs(b.y - a.y) > abs(b.x - a.x);
  Bool swapped = along(a, follows_y) > along(b, follows_y);
  Vec2 p = sel(swapped, b, a);
  Vec2 q = sel(swapped, a, b);
  Vec2 at = sel(swapped, Vec2(range.y, range.x), range);
  Vec2 w = Vec2(view_w(sel(swapped, far, near), u.depth), view_w(sel(swapped, near, far), u.depth));
  Float low = along(p, follows_y);
  Float high = along(q, follows_y);
  Bool has_extent = high - low > 0.01f;
  Float slope = sel(has_extent, (across(q, follows_y) - across(p, follows_y)) / sel(has_extent, high - low, Float(1.0f)),
                    Float(0.0f));
  Vec2 rows = nearer_beside(x, y, 1, 0, at, p, q, slope, w, follows_y);
  Vec2 columns = nearer_beside(x, y, 0, 1, at, p, q, slope, w, follows_y);
  ends = Vec4(low, high, at.x, at.y);
  widths = Vec4(rows.x, rows.y, columns.x, columns.y);
  follows = sel(follows_y, Float(1.0f), Float(0.0f));

  // A trapezium over whole pixels along the beam. Across it reaches a pixel beyond the beam's foot: half a pixel for
  // the pixels' own width, half for the ends, where the middle of what a pixel holds of the beam is not the pixel's.
  Float low_foot = (width(rows.x, w.x) + width(columns.x, w.x)) * 0.5f;
  Float high_foot = (width(rows.y, w.y) + width(columns.y, w.y)) * 0.5f;
  // Offsets change linearly along the picture, so between the ends a foot is no wider than the line between its
  // ends, unless an end has been limited.
  Bool limited = max_of(low_foot, high_foot) > u.picture.z * 0.5f;
  Float widest = max_of(low_foot, high_foot);
  Bool at_high = corner == 1 || corner == 2 || corner == 4;
  Bool above = corner == 2 || corner == 4 || corner == 5;
  Float m = sel(at_high, floor(high) + 1.0f, floor(low));
  // A beam across whose ends the trapezium goes on to whole pixels gets the wider foot if it is short.
  Float half_width = sel(limited || high - low < 4.0f, widest, sel(at_high, high_foot, low_foot)) + 1.0f +
                     sel(has_extent, abs(high_foot - low_foot) / max_of(high - low, 4.0f), Float(0.0f));
  Float n = across(p, follows_y) + slope * (m - low) + sel(above, half_width, -half_width);
  Float px = sel(follows_y, n, m);
  Float py = sel(follows_y, m, n);
  Vec4 place = Vec4(2.0f * (px / u.picture.x) - 1.0f, 2.0f * (py / u.picture.y) - 1.0f, Float(0.5f), Float(1.0f));
  // Outside the volume: not drawn.
  set_position(sel(drawn, place, Vec4(2.0f, 2.0f, 0.5f, 1.0f)));
}
#else
OUTPUT(0, Vec4, haze)
#include "passes/shared/optics.glsl"
#include "passes/medium/medium.glsl"

// The beam's distance from its start where it crosses a line across the picture's axis that it follows.
Float distance_at(Float line) {
  Float size = sel(follows > 0.5f, Float(u.picture.y), Float(u.picture.x));
  Float scale = sel(follows > 0.5f, Float(u.window.y), Float(u.window.x));
  Float offset = sel(follows > 0.5f, Float(u.window.w), Float(u.window.z));
  Float q = sel(follows > 0.5f, start.y, start.x);
  Float d = sel(follows > 0.5f, way.y, way.x);
  Float window = (line / size - offset) / scale;
  Float rise = d;
  Float left = window - q;
  if (u.depth.z > 0.5f) {
    rise = d - window * way.z;
    left = window * start.z - q;
  }
  Float at = left / sel(rise != 0.0f, rise, Float(1.0e-20f));
  at = clamp_to(at, min_of(ends.z, ends.w), max_of(ends.z, ends.w));
  return sel(line <= ends.x, ends.z, sel(line >= ends.y, ends.w, at));
}

// Share of a beam's light below x pixels from its middle, across: it is the image of a parallelogram of even
// brightness, a trapezoid of half widths |a - b| / 2 at its top and (a + b) / 2 at its foot.
Float share_below(Float x, Float a, Float b) {
  Float larger = max_of(a, b);
  Float smaller = min_of(a, b);
  Float top = (larger - smaller) * 0.5f;
  Float foot = (larger + smaller) * 0.5f;
  Float side = min_of(abs(x), foot);
  Float on_slope = max_of(foot - side, 0.0f);
  Float half_share = sel(side <= top, side / larger, 0.5f - on_slope * on_slope / (2.0f * larger * smaller));
  return 0.5f + sel(x < 0.0f, -half_share, half_share);
}

void main() {
  Vec4 range = texel_fetch(view_range, floor_to_int(frag_x()), floor_to_int(frag_y()));
  Float line = sel(follows > 0.5f, frag_y(), frag_x());
  Float s0 = distance_at(line - 0.5f);
  Float s1 = distance_at(line + 0.5f);

  // What lies behind the first surface is hidden.
  Bool turned = way.z < 0.0f;
  Float nearer = sel(turned, max_of(s0, s1), min_of(s0, s1));
  Float farther = sel(turned, min_of(s0, s1), max_of(s0, s1));
  Float z0 = start.z + way.z * nearer;
  Float z1 = start.z + way.z * farther;
  Bool runs = z1 - z0 > 1.0e-9f;
  Float share = sel(runs, clamp_to((range.x - z0) / sel(runs, z1 - z0, Float(1.0f)), 0.0f, 1.0f),
                    sel(z0 < range.x, Float(1.0f), Float(0.0f)));
  Float end = nearer + (farther - nearer) * share;
  Float length = abs(end - nearer);
  Float middle = (nearer + end) * 0.5f;
  Vec3 q = start + way * middle;

  // Which share of the beam's width this pixel has.
  Vec2 p = pixel_of(q);
  Float from_middle = sel(follows > 0.5f, frag_x() - p.x, frag_y() - p.y);
  Float span = ends.w - ends.z;
  Float f = clamp_to((middle - ends.z) / sel(span != 0.0f, span, Float(1.0f)), 0.0f, 1.0f);
  Float w = view_w(q, u.depth);
  Float a = width(widths.x * (1.0f - f) + widths.y * f, w);
  Float b = width(widths.z * (1.0f - f) + widths.w * f, w);
  Float part = share_below(from_middle + 0.5f, a, b) - share_below(from_middle - 0.5f, a, b);
  Bool lit = part > 0.0f && length > 0.0f;
  discard_if(!lit);

  // Length over the pixel's area across its ray: in a perspective picture A z^3 / d, integrated along the beam.
  Float distance = q.z;
  Float cosine = -way.z;
  Float over_area = length / u.picture.w;
  if (u.depth.z > 0.5f) {
    distance = length3(q);
    cosine = -dot3(way, q) / max_of(distance, 1.0e-20f);
    Float other = start.z + way.z * end;
    over_area = over_area / (z0 * other) * (distance / q.z);
  }
  Vec3 left = medium_transmittance(middle + max_of(distance - range.y, 0.0f));
  Float amount = part * over_area * phase_function(cosine);
  haze = sel(lit, Vec4(Vec3(u.intensity) * Vec3(u.scattering) * (flux * left) * amount, Float(0.0f)), Vec4(0.0f));
}
#endif
