// Where a ray meets a surface that a frame has seen: the surface is known as a texture of positions
// (w != 0 where there is one), one texel a direction of light. Needs view_space.glsl.

// The signed gap between a point and the surface that the frame sees at the same place: negative
// before the surface, positive behind it, metres. Along a ray it is a linear function for any plane,
// in parallel and perspective views alike: z(p) - z(surface), or (z(p) / z(surface) - 1) * scale.
struct Gap {
  Float value;
  Bool inside;   // the point lies in the frame's window
  Bool covered;  // and there is a surface
};

// A surface's z (parallel) or 1/z (perspective) at a texel; both are linear over a plane. Of a cube: z along `face`.
Float gap_height(Vec4 texel, mat4 from_scene, vec4 depth, Int face) {
  Vec3 q = in_face(view_coordinates(from_scene, Vec3(texel)), face, depth);
  Float height = q.z;
  if (depth.z > 0.5f) height = 1.0f / sel(q.z > 0.0f, q.z, Float(1.0e-20f));
  return height;
}

Float gap_of_height(Float height, Float z, vec4 depth, Float scale) {
  Float value = z - height;
  if (depth.z > 0.5f) value = (z * height - 1.0f) * scale;
  return value;
}

// The gap at p. `smoothly` interpolates between the four nearest texels where all are covered and no
// steeper than 83 degrees; elsewhere, and otherwise, the texel that holds p decides.
Gap gap_at(Texture positions, mat4 from_scene, vec4 window, vec4 depth, Vec3 p, Float scale,
           bool smoothly) {
  Vec3 at = view_coordinates(from_scene, p);
  Int face = view_face(at, depth);
  Vec3 q = in_face(at, face, depth);
  Vec2 uv = view_uv(at, window, depth);
  Gap gap;
  gap.inside = inside_unit(uv.x, uv.y);
  Vec4 nearest = fetch_nearest(positions, uv.x, uv.y);
  gap.covered = gap.inside && nearest.w != 0.0f;
  Float height = gap_height(nearest, from_scene, depth, face);
  if (smoothly) {
    Float x = uv.x * Float(texture_width(positions)) - 0.5f;
    Float y = uv.y * Float(texture_height(positions)) - 0.5f;
    Int x0 = floor_to_int(x);
    Int y0 = floor_to_int(y);
    Float fx = clamp_to(x - Float(x0), 0.0f, 1.0f);
    Float fy = clamp_to(y - Float(y0), 0.0f, 1.0f);
    Vec4 t00 = fetch_clamped(positions, x0, y0);
    Vec4 t10 = fetch_clamped(positions, x0 + 1, y0);
    Vec4 t01 = fetch_clamped(positions, x0, y0 + 1);
    Vec4 t11 = fetch_clamped(positions, x0 + 1, y0 + 1);
    Float h00 = gap_height(t00, from_scene, depth, face);
    Float h10 = gap_height(t10, from_scene, depth, face);
    Float h01 = gap_height(t01, from_scene, depth, face);
    Float h11 = gap_height(t11, from_scene, depth, face);
    Float low = min_of(min_of(h00, h10), min_of(h01, h11));
    Float high = max_of(max_of(h00, h10), max_of(h01, h11));
    // A texel's extent on the surface: parallel in metres; perspective in units of 1/z per 1/z.
    Float extent = max_of(Float(1.0f / (window.x * float(texture_width(positions)))),
                          Float(1.0f / (window.y * float(texture_height(positions)))));
    Float steepest = 8.0f * extent;
    if (depth.z > 0.5f) steepest = steepest * high;
    Bool whole = t00.w != 0.0f && t10.w != 0.0f && t01.w != 0.0f && t11.w != 0.0f &&
                 high - low <= steepest;
    Float bottom = h00 + (h10 - h00) * fx;
    Float top = h01 + (h11 - h01) * fx;
    height = sel(whole, bottom + (top - bottom) * fy, height);
  }
  gap.value = gap_of_height(height, q.z, depth, scale);
  return gap;
}

struct Hit {
  Float distance;  // along the ray, metres
  Float residual;  // what is left of the gap there, metres, not negative
  Bool inside;     // the hit lies in the frame's window
  Bool left;       // the ray strayed out of the window and was never seen behind a surface
  Bool covered;    // and on a surface
};

// The paper's derivative-free estimator (Shah et al. 2007, appendix's modified Newton): the distance
// from the ray's start to the surface point under the current guess is the next guess.
Hit intersect_paper(Texture positions, mat4 from_scene, vec4 window, vec4 depth, Vec3 start,
                    Vec3 direction, Float first_guess, int iterations) {
  Float t = first_guess;
  for (int k = 0; k < iterations; k++) {
    Vec2 uv = view_uv(view_coordinates(from_scene, start + direction * t), window, depth);
    Vec4 texel = fetch_nearest(positions, uv.x, uv.y);
    Bool known = inside_unit(uv.x, uv.y) && texel.w != 0.0f;
    t = sel(known, length3(Vec3(texel) - start), t);
    TRACE(distance, t);
  }
  Gap gap = gap_at(positions, from_scene, window, depth, start + direction * t,
                   view_w(view_coordinates(from_scene, start), depth), false);
  Hit hit;
  hit.distance = t;
  hit.residual = abs(gap.value);
  hit.inside = gap.inside;
  hit.left = Bool(false);
  hit.covered = gap.covered;
  return hit;
}

// The surface point that the frame sees at p, interpolated where all four texels around are covered.
Vec4 surface_point(Texture positions, mat4 from_scene, vec4 window, vec4 depth, Vec3 p) {
  Vec2 uv = view_uv(view_coordinates(from_scene, p), window, depth);
  Vec4 smooth_point = fetch_bilinear(positions, uv.x, uv.y);
  Vec4 nearest = fetch_nearest(positions, uv.x, uv.y);
  Vec4 known = sel(smooth_point.w == nearest.w, smooth_point, nearest);
  return sel(inside_unit(uv.x, uv.y), known, Vec4(0.0f));
}

// Newton-Raphson on f(x) = |P(x) - p(x)|, the distance between the ray's point at x and the surface point under it,
// with a forward difference for f' (Shah et al. 2007, appendix), from x = 0.10 m as there. Guarded: where f' is
// less than 1e-3 (the difference straddles f's kink at the root, or the surface is lost) the derivative-free step
// |P(x) - start| is taken, and no step leaves the range of depths.
Hit intersect_newton(Texture positions, mat4 from_scene, vec4 window, vec4 depth, Vec3 start,
                     Vec3 direction, int iterations) {
  Float reach = Float(depth.y - depth.x);
  Vec3 q = view_coordinates(from_scene, start);
  Float stencil = view_w(q, depth) *
                  max_of(Float(1.0f / (window.x * float(texture_width(positions)))),
                         Float(1.0f / (window.y * float(texture_height(positions)))));
  Float x = Float(0.1f);
  for (int k = 0; k < iterations; k++) {
    Vec3 p = start + direction * x;
    Vec4 under = surface_point(positions, from_scene, window, depth, p);
    Vec3 ahead = start + direction * (x + stencil);
    Vec4 under_ahead = surface_point(positions, from_scene, window, depth, ahead);
    Float f = length3(Vec3(under) - p);
    Float slope = (length3(Vec3(under_ahead) - ahead) - f) / stencil;
    Bool steep = abs(slope) > 1.0e-3f && under.w != 0.0f && under_ahead.w != 0.0f;
    Float newton = x - f / sel(steep, slope, Float(1.0f));
    Float next = sel(steep, newton, sel(under.w != 0.0f, length3(Vec3(under) - start), x * 0.5f));
    x = clamp_to(next, 0.0f, reach);
    TRACE(distance, x);
  }
  Gap gap = gap_at(positions, from_scene, window, depth, start + direction * x, view_w(q, depth), true);
  Hit hit;
  hit.distance = x;
  hit.residual = abs(gap.value);
  hit.inside = gap.inside;
  hit.left = Bool(false);
  hit.covered = gap.covered;
  return hit;
}

// Between which distances a ray comes behind a surface, and where to look first.
struct Bracket {
  Float low;       // a point before the surface, and its gap, not above 0
  Float gap_low;
  Float high;      // a point behind it, where bracketed
  Float gap_high;
  Bool bracketed;
  Float guess;
};

// The bracketed secant on the signed gap: exact in one step on any plane. Each guess is the secant of the
// two last gaps, held inside the bracket once a point behind the surface is known; where it leaves the
// bracket, regula falsi with the Illinois rule decides (an end that stays put twice loses half its weight),
// and before there is a bracket a step is at most four times the last. A point without a surface counts
// as behind it when `beyond_is_behind` (a ray leaves a closed body through its silhouette), else as
// before it (a ray over a hole in the floor flies on). Every gap interpolates the surface: a texel's own height
// is off by its slope, and one such gap in the bracket keeps the root out. Leaves the bracket in `from`.
Hit close_in(Texture positions, mat4 from_scene, vec4 window, vec4 depth, Vec3 start, Vec3 direction,
             int iterations, bool beyond_is_behind, INOUT(Bracket) from) {
  Float scale = view_w(view_coordinates(from_scene, start), depth);
  Float reach = Float(depth.y - depth.x);
  Float low = from.low;
  Float gap_low = from.gap_low;
  Float high = from.high;
  Float gap_high = from.gap_high;
  Bool bracketed = from.bracketed;
  Bool strayed = Bool(false);
  Int last_side = Int(0);
  Float last = low;
  Float last_gap = gap_low;
  Float t = from.guess;
  Gap gap;
  for (int k = 0; k < iterations + 1; k++) {
    gap = gap_at(positions, from_scene, window, depth, start + direction * t, scale, true);
    TRACE(distance, t);
    TRACE(gap, gap.value);
    Float value = gap.value;
    if (beyond_is_behind) {
      value = sel(gap.covered, value, -gap_low);
    } else {
      value = sel(gap.covered, value, gap_low);
    }
    // Outside the window nothing is known: halve the way back, and leave the bracket as it is.
    Bool known = gap.inside;
    if (beyond_is_behind) known = Bool(true);
    strayed = strayed || !known;
    Float halfway = 0.5f * (low + t);
    Bool behind = known && value >= 0.0f;
    Bool before = known && value < 0.0f;
    gap_low = sel(behind && last_side == 1, gap_low * 0.5f, gap_low);
    gap_high = sel(before && last_side == -1, gap_high * 0.5f, gap_high);
    high = sel(behind, t, high);
    gap_high = sel(behind, value, gap_high);
    low = sel(before, t, low);
    gap_low = sel(before, value, gap_low);
    bracketed = bracketed || behind;
    last_side = sel(behind, Int(1), sel(before, Int(-1), last_side));
    Float step = t - last;
    Float rise = value - last_gap;
    Bool rising = rise * step > 0.0f;
    Float secant = t - value * step / sel(rising, rise, Float(1.0f));
    Float span = gap_high - gap_low;
    Float within = low + (high - low) * clamp_to(-gap_low / sel(span > 0.0f, span, Float(1.0f)),
                                                 0.0f, 1.0f);
    Float ahead = low + clamp_to(sel(rising, secant - low, step), 0.0f,
                                 4.0f * max_of(step, reach * 1.0e-3f));
    Float next = sel(bracketed, sel(rising && secant >= low && secant <= high, secant, within), ahead);
    last = sel(known, t, last);
    last_gap = sel(known, value, last_gap);
    t = sel(known, next, halfway);
  }
  gap = gap_at(positions, from_scene, window, depth, start + direction * t, scale, true);
  TRACE(distance, t);
  TRACE(gap, gap.value);
  Hit hit;
  hit.distance = t;
  hit.residual = abs(gap.value);
  hit.inside = gap.inside;
  hit.left = strayed && !bracketed;
  hit.covered = gap.covered;
  from.low = low;
  from.gap_low = gap_low;
  from.high = high;
  from.gap_high = gap_high;
  from.bracketed = bracketed;
  from.guess = t;
  return hit;
}

// Before anything is known of the way: from the surface under the start. The first guess takes it to be
// level: a plane across the light is met exactly.
Bracket bracket_at_start(Texture positions, mat4 from_scene, vec4 window, vec4 depth, Vec3 start,
                         Vec3 direction) {
  Vec3 at = view_coordinates(from_scene, start);
  Float scale = view_w(at, depth);
  Float fall = in_face(transform_vector(from_scene, direction), view_face(at, depth), depth).z;
  Gap gap = gap_at(positions, from_scene, window, depth, start, scale, false);
  Float reach = Float(depth.y - depth.x);
  Bool above = gap.covered && gap.value < 0.0f;
  Bracket from;
  from.low = Float(0.0f);
  from.gap_low = sel(above, gap.value, -(reach * 1.0e-6f));
  from.high = Float(0.0f);
  from.gap_high = Float(0.0f);
  from.bracketed = Bool(false);
  from.guess = sel(above, -from.gap_low / max_of(fall, 0.1f), reach * 0.25f);
  return from;
}

// Steps along the ray, each half as far again as the last, to where it passes from before a surface to behind one.
// Behind a surface without having been before it, a ray may be passing under an edge: such a place is taken only
// where there is no other.
Bracket bracket_by_steps(Texture positions, mat4 from_scene, vec4 window, vec4 depth, Vec3 start,
                         Vec3 direction, Bracket from) {
  Float scale = view_w(view_coordinates(from_scene, start), depth);
  Bracket found = from;
  Bool passed = Bool(false);
  Bool was_before = Bool(false);
  Float last = Float(0.0f);
  Float last_gap = from.gap_low;
  Float t = Float(depth.y - depth.x) * (1.0f / 1024.0f);
  for (int k = 0; k < 20; k++) {
    Gap gap = gap_at(positions, from_scene, window, depth, start + direction * t, scale, false);
    Bool before = gap.covered && gap.value < 0.0f;
    Bool behind = gap.covered && gap.value >= 0.0f;
    Bool passes = behind && was_before && !passed;
    Bool takes = passes || (behind && !found.bracketed);
    found.low = sel(takes, last, found.low);
    found.gap_low = sel(takes, last_gap, found.gap_low);
    found.high = sel(takes, t, found.high);
    found.gap_high = sel(takes, gap.value, found.gap_high);
    found.bracketed = found.bracketed || behind;
    passed = passed || passes;
    was_before = before;
    last_gap = sel(before, gap.value, from.gap_low);
    last = t;
    t = t * 1.5f;
  }
  Float span = found.gap_high - found.gap_low;
  found.guess = found.low + (found.high - found.low) *
                                clamp_to(-found.gap_low / sel(span > 0.0f, span, Float(1.0f)), 0.0f, 1.0f);
  return found;
}

// Did the search end on a surface, to two texels' extents?
Bool is_met(Hit hit, Texture positions, mat4 from_scene, vec4 window, vec4 depth, Vec3 p) {
  Float extent = view_w(view_coordinates(from_scene, p), depth) *
                 max_of(Float(1.0f / (window.x * float(texture_width(positions)))),
                        Float(1.0f / (window.y * float(texture_height(positions)))));
  return hit.inside && hit.covered && hit.residual <= 2.0f * extent;
}

Bracket chosen(Bool condition, Bracket a, Bracket b) {
  Bracket c;
  c.low = sel(condition, a.low, b.low);
  c.gap_low = sel(condition, a.gap_low, b.gap_low);
  c.high = sel(condition, a.high, b.high);
  c.gap_high = sel(condition, a.gap_high, b.gap_high);
  c.bracketed = (condition && a.bracketed) || (!condition && b.bracketed);
  c.guess = sel(condition, a.guess, b.guess);
  return c;
}

// The secant from the surface under the start. Where that has not ended on a surface, it goes on; where it has
// lost the surface (which is seen as a narrow strip, and guesses leap over it), from a bracket found by steps.
Hit intersect_secant(Texture positions, mat4 from_scene, vec4 window, vec4 depth, Vec3 start,
                     Vec3 direction, int iterations, bool beyond_is_behind) {
  Bracket first = bracket_at_start(positions, from_scene, window, depth, start, direction);
  Bracket from = first;
  Hit hit = close_in(positions, from_scene, window, depth, start, direction, iterations, beyond_is_behind, from);
  if (!beyond_is_behind) {
    Bool lost = !is_met(hit, positions, from_scene, window, depth, start + direction * hit.distance);
    if (any_lane(lost)) {
      Bracket found = bracket_by_steps(positions, from_scene, window, depth, start, direction, first);
      Bool near = hit.inside && hit.covered && from.bracketed;
      Bool again = lost && (near || found.bracketed);
      from = chosen(near, from, found);
      Hit second = close_in(positions, from_scene, window, depth, start, direction, iterations, false, from);
      again = again && (!near || second.residual < hit.residual);
      hit.distance = sel(again, second.distance, hit.distance);
      hit.residual = sel(again, second.residual, hit.residual);
      hit.inside = (again && second.inside) || (!again && hit.inside);
      hit.left = (again && second.left) || (!again && hit.left);
      hit.covered = (again && second.covered) || (!again && hit.covered);
    }
  }
  return hit;
}

// Distance impostors (Szirmay-Kalos, Aszodi, Lazanyi, Premecz 2005): the frame is a cube around a point near the
// casters. q = |p| / D(p), the point's distance from there over the surface's in the same direction, passes 1 where
// the ray meets the surface, and is linear along the ray over any plane. Theirs are the start, exact where one plane
// lies in the ray's direction and in the start's, and the steps: with D of the ray's own direction from the start
// until the ray has once been too far, after that the secant between the last point before and the last behind.
Hit intersect_impostor(Texture positions, mat4 from_scene, vec4 window, vec4 depth, Vec3 start, Vec3 direction,
                       Vec3 centre, int iterations) {
  Float reach = Float(depth.y);
  Gap ahead = gap_at(positions, from_scene, window, depth, centre + direction * reach, Float(1.0f), true);
  Float share = ahead.value + 1.0f;
  Float along = sel(ahead.covered && share > 1.0e-6f, reach / sel(share > 1.0e-6f, share, Float(1.0f)), reach);
  Gap gap = gap_at(positions, from_scene, window, depth, start, Float(1.0f), true);
  // A start at the very centre has no direction, and q = 0.
  Float q_under = sel(gap.covered, gap.value + 1.0f, Float(0.0f));
  Float under = Float(0.0f);
  Float over = Float(0.0f);
  Float q_over = Float(1.0f);
  Bool overshot = Bool(false);
  Float d = max_of(along * (1.0f - q_under), 0.0f);
  Float q = Float(0.0f);
  for (int k = 0; k < iterations + 1; k++) {
    gap = gap_at(positions, from_scene, window, depth, start + direction * d, Float(1.0f), true);
    TRACE(distance, d);
    q = sel(gap.covered, gap.value + 1.0f, Float(0.0f));
    TRACE(quotient, q);
    Bool behind = q > 1.0f;
    over = sel(behind, d, over);
    q_over = sel(behind, q, q_over);
    under = sel(behind, under, d);
    q_under = sel(behind, q_under, q);
    overshot = overshot || behind;
    Float rise = q_over - q_under;
    Bool rising = rise > 1.0e-9f;
    Float secant = under + (over - under) * (1.0f - q_under) / sel(rising, rise, Float(1.0f));
    Float next = sel(overshot && rising, secant, d + along * (1.0f - q));
    if (k < iterations) d = clamp_to(next, 0.0f, 2.0f * reach);
  }
  Hit hit;
  hit.distance = d;
  hit.residual = abs(q - 1.0f) * length3(start + direction * d - centre);
  hit.inside = Bool(true);
  hit.left = Bool(false);
  hit.covered = gap.covered;
  return hit;
}
