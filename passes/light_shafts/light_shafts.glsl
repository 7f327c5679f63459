// Draws each beam of a caster's light as what the medium scatters of it towards the camera. light_shafts.md
// explains.
#include "passes/shared/homogeneous_medium.glsl"
UNIFORMS_BEGIN
#include "passes/light_shafts/light_shafts_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, beam_start)
TEXTURE(1, beam_way)
TEXTURE(2, beam_flux)
TEXTURE(3, view_range)
VARYING_FLAT(0, Vec3, start)           // camera's view, metres
VARYING_FLAT(3, Vec3, way)             // likewise, unit
VARYING_FLAT(6, Vec3, flux)
VARYING_FLAT(9, Vec2, ends)            // lower and upper, along the axis that the beam follows, pixels
VARYING_FLAT(11, Vec2, end_distances)  // of these from the beam's start, metres
VARYING_FLAT(13, Vec2, row_widths)     // at the two ends, across: to a neighbour in the grid's rows,
VARYING_FLAT(15, Vec2, column_widths)  // and in its columns, pixels times view_w
VARYING_FLAT(17, Float, axis)          // of the picture that the beam follows: 0 for x, 1 for y
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"

// Pixel coordinates of a point in the camera's view.
Vec2 pixel_of(Vec3 q) {
  Float w = view_w(u.view, q);
  return Vec2((q.x / w * u.view.scale.x + u.view.offset.x) * u.picture.x,
              (q.y / w * u.view.scale.y + u.view.offset.y) * u.picture.y);
}

// A beam's width from an offset across: at least a pixel, so that none falls between, and not endless.
Float beam_width(Float offset, Float w) { return clamp_to(abs(offset) / w, 1.0f, u.widest); }

#ifdef VERTEX_STAGE
#include "passes/light_shafts/beam_image.glsl"

void main() {
  Int id = vertex_id();
  Int beam = id / 6;
  Int corner = id - beam * 6;
  Int y = beam / Int(u.beams_a_side);
  Int x = beam - y * Int(u.beams_a_side);
  Vec4 from = texel_fetch(beam_start, x, y);
  start = view_coordinates(u.view, Vec3(from));
  way = transform_vector(u.view.from_scene, Vec3(texel_fetch(beam_way, x, y)));
  flux = Vec3(texel_fetch(beam_flux, x, y));
  Vec2 range = in_view(start, way, from.w);
  Bool drawn = is_beam(x, y) && range.y > range.x;

  Line line = image_of(start, way, range);
  row_widths = nearer_beside(line, x, y, 1, 0);
  column_widths = nearer_beside(line, x, y, 0, 1);
  ends = Vec2(along(line, line.lower), along(line, line.upper));
  end_distances = line.at;
  axis = sel(line.follows_y, Float(1.0f), Float(0.0f));

  Vec2 p = corner_of(line, feet_of(line, row_widths, column_widths), corner);
  Float clip_x = 2.0f * (p.x / u.picture.x) - 1.0f;
  Float clip_y = 2.0f * (p.y / u.picture.y) - 1.0f;
  // Outside the volume: not drawn.
  set_position(sel(drawn, Vec4(clip_x, clip_y, Float(0.5f), Float(1.0f)), Vec4(2.0f, 2.0f, 0.5f, 1.0f)));
}
#else
OUTPUT(0, Vec4, haze)
#include "passes/shared/optics.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/medium_optics.glsl"
#include "passes/shared/view_range.glsl"

// The coordinate along the picture's axis that the beam follows, and the one across.
Float along(Float x, Float y) { return sel(axis > 0.5f, y, x); }
Float across(Float x, Float y) { return sel(axis > 0.5f, x, y); }

// The beam's distance from its start where it crosses a line across the picture's axis that it follows.
Float distance_at(Float line) {
  Float size = along(Float(u.picture.x), Float(u.picture.y));
  Float scale = along(Float(u.view.scale.x), Float(u.view.scale.y));
  Float offset = along(Float(u.view.offset.x), Float(u.view.offset.y));
  Float q = along(start.x, start.y);
  Float d = along(way.x, way.y);
  Float window = (line / size - offset) / scale;
  Float rise = d;
  Float left = window - q;
  if (u.view.kind != VIEW_PARALLEL) {
    rise = d - window * way.z;
    left = window * start.z - q;
  }
  Float at = left / sel(rise != 0.0f, rise, Float(1.0e-20f));
  Float first = min_of(end_distances.x, end_distances.y);
  Float last = max_of(end_distances.x, end_distances.y);
  at = clamp_to(at, first, last);
  return sel(line <= ends.x, end_distances.x, sel(line >= ends.y, end_distances.y, at));
}

// The piece of a beam that a pixel shows, in distances from the beam's start, metres.
struct Piece {
  Float nearer;  // to the camera
  Float end;     // its other end, or where it goes behind the first surface
  Float z;       // of the nearer end along the camera's axis
};

// Of the whole pixel along the picture's axis. What lies behind the first surface is hidden.
Piece piece_in(Float line, IN(ViewRange) range) {
  Float s0 = distance_at(line - 0.5f);
  Float s1 = distance_at(line + 0.5f);
  Bool turned = way.z < 0.0f;
  Piece piece;
  piece.nearer = sel(turned, max_of(s0, s1), min_of(s0, s1));
  Float farther = sel(turned, min_of(s0, s1), max_of(s0, s1));
  piece.z = start.z + way.z * piece.nearer;
  Float z1 = start.z + way.z * farther;
  Bool runs = z1 - piece.z > 1.0e-9f;
  Float before_surface = (range.surface_z - piece.z) / sel(runs, z1 - piece.z, Float(1.0f));
  Float share = sel(runs, clamp_to(before_surface, 0.0f, 1.0f),
                    sel(piece.z < range.surface_z, Float(1.0f), Float(0.0f)));
  piece.end = piece.nearer + (farther - piece.nearer) * share;
  return piece;
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

// Which share of the beam's width this pixel has, at a distance from the beam's start, q in the camera's
// view.
Float share_across(Float at, Vec3 q) {
  Vec2 p = pixel_of(q);
  Float from_middle = across(frag_x() - p.x, frag_y() - p.y);
  Float span = end_distances.y - end_distances.x;
  Float f = clamp_to((at - end_distances.x) / sel(span != 0.0f, span, Float(1.0f)), 0.0f, 1.0f);
  Float w = view_w(u.view, q);
  Float a = beam_width(row_widths.x * (1.0f - f) + row_widths.y * f, w);
  Float b = beam_width(column_widths.x * (1.0f - f) + column_widths.y * f, w);
  return share_below(from_middle + 0.5f, a, b) - share_below(from_middle - 0.5f, a, b);
}

// A piece's length over the pixel's area across its ray, at a point at `distance` from the camera: in a
// perspective picture A z^3 / d, integrated along the beam.
Float length_over_area(IN(Piece) piece, Float length, Float z, Float distance) {
  Float over_area = length / u.pixel_area;
  if (u.view.kind != VIEW_PARALLEL) {
    Float other = start.z + way.z * piece.end;
    over_area = over_area / (piece.z * other) * (distance / z);
  }
  return over_area;
}

void main() {
  ViewRange range = fetch_view_range(view_range);
  Piece piece = piece_in(along(frag_x(), frag_y()), range);
  Float length = abs(piece.end - piece.nearer);
  Float middle = (piece.nearer + piece.end) * 0.5f;
  Vec3 q = start + way * middle;
  Float part = share_across(middle, q);
  Bool lit = part > 0.0f && length > 0.0f;
  discard_if(!lit);

  Float distance = q.z;
  Float cosine = -way.z;
  if (u.view.kind != VIEW_PARALLEL) {
    distance = length3(q);
    cosine = -dot3(way, q) / max_of(distance, 1.0e-20f);
  }
  Vec3 left = medium_transmittance(u.medium, middle + max_of(distance - range.entry, 0.0f));
  Float over_area = length_over_area(piece, length, q.z, distance);
  Float amount = part * over_area * phase_function(u.medium, cosine);
  Vec3 scattered = Vec3(u.intensity) * Vec3(u.medium.scattering) * (flux * left) * amount;
  haze = sel(lit, Vec4(scattered, Float(0.0f)), Vec4(0.0f));
}
#endif
