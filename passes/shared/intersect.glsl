// Where a ray meets a surface that a view has seen: the surface is known as a texture of positions, one texel
// a direction of light. Needs view_space.glsl, ray.glsl and position_texel.glsl.

// A ray's search for such a surface.
struct Search {
  Ray ray;
  Float scale;            // what a perspective view's gaps are measured by: view_w of the ray's start
  int iterations;
  float start;            // where intersect_paper and intersect_newton begin, metres
  float epsilon;          // Newton's forward difference, metres; 0: a texel's extent
  bool guarded;           // intersect_newton
  // Whether a point without a surface counts as behind it (a ray leaves a closed body through its silhouette)
  // or as before it (a ray over a hole in the floor flies on).
  bool beyond_is_behind;
  // Where on the ray surfaces can be, metres: steps along it begin at `first`, and the longest reach 2.17
  // times `reach` from there. Nowhere, if that is 0.
  Float first;
  Float reach;
};

Search search_along(IN(View) view, IN(Ray) ray, int iterations, bool beyond_is_behind) {
  Search search;
  search.ray = ray;
  search.scale = view_w(view, view_coordinates(view, ray.start));
  search.iterations = iterations;
  search.start = 0.0f;
  search.epsilon = 0.0f;
  search.guarded = true;
  search.beyond_is_behind = beyond_is_behind;
  search.first = Float(0.0f);
  search.reach = Float(view.far - view.near);
  return search;
}

// The larger extent of a texel across the view, metres for each metre of view_w.
Float texel_extent(Texture t, IN(View) view) {
  return max_of(Float(1.0f / (view.scale.x * float(texture_width(t)))),
                Float(1.0f / (view.scale.y * float(texture_height(t)))));
}

// The same at p, metres.
Float texel_extent_at(Texture t, IN(View) view, Vec3 p) {
  return view_w(view, view_coordinates(view, p)) * texel_extent(t, view);
}

// The signed gap between a point and the surface that the view sees at the same place: negative
// before the surface, positive behind it, metres. Along a ray it is a linear function for any plane,
// in parallel and perspective views alike: z(p) - z(surface), or (z(p) / z(surface) - 1) * scale.
struct Gap {
  Float value;
  Bool inside;   // the point lies in the view's window
  Bool covered;  // and there is a surface
};

// A surface's z (parallel) or 1/z (perspective) at a texel; both are linear over a plane. Of a cube: z along
// `face`.
Float gap_height(IN(View) view, Vec4 texel, Int face) {
  Vec3 q = in_face(view, view_coordinates(view, Vec3(texel)), face);
  Float height = q.z;
  if (view.kind != VIEW_PARALLEL) height = 1.0f / sel(q.z > 0.0f, q.z, Float(1.0e-20f));
  return height;
}

// How much the heights of neighbouring texels may differ, the highest being `high`: that of 83 degrees. A
// texel's extent on the surface is in metres (parallel), or in units of 1/z per 1/z (perspective).
Float steepest_rise(Texture positions, IN(View) view, Float high) {
  Float rise = 8.0f * texel_extent(positions, view);
  if (view.kind != VIEW_PARALLEL) rise = rise * high;
  return rise;
}

// What a view sees at a place: gap_height of it, and whether it is a surface.
struct Seen {
  Float height;
  Bool covered;
};

// In the texel that holds (u, v).
Seen seen_in_texel(Texture positions, IN(View) view, Vec2 uv, Int face) {
  Vec4 nearest = fetch_nearest(positions, uv.x, uv.y);
  Seen seen;
  seen.height = gap_height(view, nearest, face);
  seen.covered = is_covered(nearest);
  return seen;
}

// Between the four nearest texels where all are covered and no steeper than 83 degrees; elsewhere in the one
// of them that holds (u, v).
Seen seen_between(Texture positions, IN(View) view, Vec2 uv, Int face) {
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
  Float h00 = gap_height(view, t00, face);
  Float h10 = gap_height(view, t10, face);
  Float h01 = gap_height(view, t01, face);
  Float h11 = gap_height(view, t11, face);
  Float low = min_of(min_of(h00, h10), min_of(h01, h11));
  Float high = max_of(max_of(h00, h10), max_of(h01, h11));
  Bool whole = is_covered(t00) && is_covered(t10) && is_covered(t01) && is_covered(t11) &&
               high - low <= steepest_rise(positions, view, high);
  Float bottom = h00 + (h10 - h00) * fx;
  Float top = h01 + (h11 - h01) * fx;
  Bool right = fx >= 0.5f;
  Bool upper = fy >= 0.5f;
  Float own = sel(upper, sel(right, h11, h01), sel(right, h10, h00));
  Seen seen;
  seen.height = sel(whole, bottom + (top - bottom) * fy, own);
  seen.covered = sel(upper, sel(right, t11.w, t01.w), sel(right, t10.w, t00.w)) != 0.0f;
  return seen;
}

// The gap at p, against the texel that holds p or, `smoothly`, between the four nearest.
Gap gap_at(Texture positions, IN(View) view, Vec3 p, Float scale, bool smoothly) {
  Vec3 at = view_coordinates(view, p);
  Int face = view_face(view, at);
  Vec3 q = in_face(view, at, face);
  Vec2 uv = view_uv(view, at);
  Seen seen;
  if (smoothly) {
    seen = seen_between(positions, view, uv, face);
  } else {
    seen = seen_in_texel(positions, view, uv, face);
  }
  Gap gap;
  gap.inside = inside_unit(uv.x, uv.y);
  gap.covered = gap.inside && seen.covered;
  gap.value = q.z - seen.height;
  if (view.kind != VIEW_PARALLEL) gap.value = (q.z * seen.height - 1.0f) * scale;
  return gap;
}

struct Hit {
  Float distance;  // along the ray, metres
  Float residual;  // what is left of the gap there, metres, not negative
  Bool inside;     // the hit lies in the view's window
  Bool left;       // the ray strayed out of the window and was never seen behind a surface
  Bool covered;    // and on a surface
};

Hit hit_at(Float distance, Gap gap) {
  Hit hit;
  hit.distance = distance;
  hit.residual = abs(gap.value);
  hit.inside = gap.inside;
  hit.left = Bool(false);
  hit.covered = gap.covered;
  return hit;
}

// The residual of a search that has come to no place at all, on a surface or off it.
Float lost_residual() { return Float(1.0e30f); }
Bool is_found(IN(Hit) hit) { return hit.residual < 1.0e29f; }

Hit chosen(Bool condition, IN(Hit) a, IN(Hit) b) {
  Hit hit;
  hit.distance = sel(condition, a.distance, b.distance);
  hit.residual = sel(condition, a.residual, b.residual);
  hit.inside = sel(condition, a.inside, b.inside);
  hit.left = sel(condition, a.left, b.left);
  hit.covered = sel(condition, a.covered, b.covered);
  return hit;
}

// Did the search end on a surface, to two texels' extents? p: where it ended.
Bool is_met(IN(Hit) hit, Texture positions, IN(View) view, Vec3 p) {
  return hit.inside && hit.covered && hit.residual <= 2.0f * texel_extent_at(positions, view, p);
}

// The paper's derivative-free estimator (Shah et al. 2007, appendix's modified Newton): the distance
// from the ray's start to the surface point under the current guess is the next guess.
Hit intersect_paper(Texture positions, IN(View) view, IN(Search) search) {
  Float t = Float(search.start);
  for (int k = 0; k < search.iterations; k++) {
    Vec2 uv = view_uv(view, view_coordinates(view, point_along(search.ray, t)));
    Vec4 under = fetch_nearest(positions, uv.x, uv.y);
    Bool known = inside_unit(uv.x, uv.y) && is_covered(under);
    t = sel(known, length3(Vec3(under) - search.ray.start), t);
    TRACE(distance, t);
  }
  return hit_at(t, gap_at(positions, view, point_along(search.ray, t), search.scale, false));
}

// The surface point that the view sees at p, interpolated where all four texels around are covered.
Vec4 surface_point(Texture positions, IN(View) view, Vec3 p) {
  Vec2 uv = view_uv(view, view_coordinates(view, p));
  Vec4 smooth_point = fetch_bilinear(positions, uv.x, uv.y);
  Vec4 nearest = fetch_nearest(positions, uv.x, uv.y);
  Vec4 known = sel(smooth_point.w == nearest.w, smooth_point, nearest);
  return sel(inside_unit(uv.x, uv.y), known, Vec4(0.0f));
}

// Newton-Raphson on f(x) = |P(x) - p(x)|, the distance between the ray's point at x and the surface point
// under it, with a forward difference for f' (Shah et al. 2007, appendix). Guarded: where f' is less than
// 1e-3 (the difference straddles f's kink at the root, or the surface is lost) the derivative-free step
// |P(x) - start| is taken, and no step leaves the range of depths. Unguarded, as the listing has it: it may
// jump to where no number is, and is lost there.
Hit intersect_newton(Texture positions, IN(View) view, IN(Search) search) {
  Float reach = Float(view.far - view.near);
  Float stencil = search.scale * texel_extent(positions, view);
  if (search.epsilon > 0.0f) stencil = Float(search.epsilon);
  Float x = Float(search.start);
  Bool finite = Bool(true);
  for (int k = 0; k < search.iterations; k++) {
    Vec3 p = point_along(search.ray, x);
    Vec4 under = surface_point(positions, view, p);
    Vec3 ahead = point_along(search.ray, x + stencil);
    Vec4 under_ahead = surface_point(positions, view, ahead);
    Float f = length3(Vec3(under) - p);
    Float slope = (length3(Vec3(under_ahead) - ahead) - f) / stencil;
    if (search.guarded) {
      Bool steep = abs(slope) > 1.0e-3f && is_covered(under) && is_covered(under_ahead);
      Float newton = x - f / sel(steep, slope, Float(1.0f));
      Float derivative_free = sel(is_covered(under), length3(Vec3(under) - search.ray.start), x * 0.5f);
      x = clamp_to(sel(steep, newton, derivative_free), 0.0f, reach);
    } else {
      // Places so far off are none that single precision can tell apart in the view.
      Bool level = slope == 0.0f;
      Float next = x - f / sel(level, Float(1.0f), slope);
      finite = finite && !level && abs(next) < 1.0e6f * reach;
      x = sel(finite, next, Float(0.0f));
    }
    TRACE(distance, x);
  }
  Hit hit = hit_at(x, gap_at(positions, view, point_along(search.ray, x), search.scale, true));
  hit.residual = sel(finite, hit.residual, lost_residual());
  hit.inside = hit.inside || !finite;
  hit.covered = hit.covered || !finite;
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

Bracket chosen(Bool condition, IN(Bracket) a, IN(Bracket) b) {
  Bracket c;
  c.low = sel(condition, a.low, b.low);
  c.gap_low = sel(condition, a.gap_low, b.gap_low);
  c.high = sel(condition, a.high, b.high);
  c.gap_high = sel(condition, a.gap_high, b.gap_high);
  c.bracketed = sel(condition, a.bracketed, b.bracketed);
  c.guess = sel(condition, a.guess, b.guess);
  return c;
}

// Where the gap is 0 if it is linear between the bracket's ends.
Float regula_falsi(IN(Bracket) bracket) {
  Float span = bracket.gap_high - bracket.gap_low;
  return bracket.low + (bracket.high - bracket.low) *
                           clamp_to(-bracket.gap_low / sel(span > 0.0f, span, Float(1.0f)), 0.0f, 1.0f);
}

// Moves an end of the bracket to the guess, whose gap is `gap` where it is known. By the Illinois rule an end
// that stays put twice loses half its weight; last_side: which end moved last, 1 high, -1 low, 0 none.
void narrow(INOUT(Bracket) bracket, INOUT(Int) last_side, Float gap, Bool known) {
  Bool behind = known && gap >= 0.0f;
  Bool before = known && gap < 0.0f;
  bracket.gap_low = sel(behind && last_side == 1, bracket.gap_low * 0.5f, bracket.gap_low);
  bracket.gap_high = sel(before && last_side == -1, bracket.gap_high * 0.5f, bracket.gap_high);
  bracket.high = sel(behind, bracket.guess, bracket.high);
  bracket.gap_high = sel(behind, gap, bracket.gap_high);
  bracket.low = sel(before, bracket.guess, bracket.low);
  bracket.gap_low = sel(before, gap, bracket.gap_low);
  bracket.bracketed = bracket.bracketed || behind;
  last_side = sel(behind, Int(1), sel(before, Int(-1), last_side));
}

// The secant of the guess and the last look before it, held inside the bracket once there is a point behind
// the surface; where it leaves the bracket, regula falsi. Before there is a bracket a step is at most four
// times the last.
Float next_guess(IN(Bracket) bracket, Float gap, Float last, Float last_gap, Float reach) {
  Float step = bracket.guess - last;
  Float rise = gap - last_gap;
  Bool rising = rise * step > 0.0f;
  Float secant = bracket.guess - gap * step / sel(rising, rise, Float(1.0f));
  Bool within = rising && secant >= bracket.low && secant <= bracket.high;
  Float ahead = bracket.low + clamp_to(sel(rising, secant - bracket.low, step), 0.0f,
                                       4.0f * max_of(step, reach * 1.0e-3f));
  return sel(bracket.bracketed, sel(within, secant, regula_falsi(bracket)), ahead);
}

// The bracketed secant on the signed gap: exact in one step on any plane. Every gap interpolates the surface:
// a texel's own height is off by its slope, and one such gap in the bracket keeps the root out. Leaves the
// bracket in `from`.
Hit close_in(Texture positions, IN(View) view, IN(Search) search, INOUT(Bracket) from) {
  Float reach = Float(view.far - view.near);
  Bool strayed = Bool(false);
  Int last_side = Int(0);
  Float last = from.low;
  Float last_gap = from.gap_low;
  for (int k = 0; k < search.iterations + 1; k++) {
    Gap gap = gap_at(positions, view, point_along(search.ray, from.guess), search.scale, true);
    TRACE(distance, from.guess);
    TRACE(gap, gap.value);
    Float beyond = from.gap_low;
    if (search.beyond_is_behind) beyond = -from.gap_low;
    Float value = sel(gap.covered, gap.value, beyond);
    // Outside the window nothing is known: halve the way back, and leave the bracket as it is.
    Bool known = gap.inside;
    if (search.beyond_is_behind) known = Bool(true);
    strayed = strayed || !known;
    Float halfway = 0.5f * (from.low + from.guess);
    narrow(from, last_side, value, known);
    Float next = next_guess(from, value, last, last_gap, reach);
    last = sel(known, from.guess, last);
    last_gap = sel(known, value, last_gap);
    from.guess = sel(known, next, halfway);
  }
  Gap gap = gap_at(positions, view, point_along(search.ray, from.guess), search.scale, true);
  TRACE(distance, from.guess);
  TRACE(gap, gap.value);
  Hit hit = hit_at(from.guess, gap);
  hit.left = strayed && !from.bracketed;
  return hit;
}

// Before anything is known of the way: from the surface under the start. The first guess takes it to be
// level: a plane across the light is met exactly.
Bracket bracket_at_start(Texture positions, IN(View) view, IN(Search) search) {
  Vec3 at = view_coordinates(view, search.ray.start);
  Float fall = in_face(view, transform_vector(view.from_scene, search.ray.direction), view_face(view, at)).z;
  Gap gap = gap_at(positions, view, search.ray.start, search.scale, false);
  Float reach = Float(view.far - view.near);
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

// Steps along the ray, each half as far again from the first place where a surface can be, to where it passes
// from before a surface to behind one. Behind a surface without having been before it, a ray may be passing
// under an edge: such a place is taken only where there is no other.
Bracket bracket_by_steps(Texture positions, IN(View) view, IN(Search) search, IN(Bracket) from) {
  Bracket found = from;
  Bool passed = Bool(false);
  Bool was_before = Bool(false);
  Float last = search.first;
  Float last_gap = from.gap_low;
  Float step = search.reach * (1.0f / 1024.0f);
  for (int k = 0; k < 20; k++) {
    Float t = search.first + step;
    Gap gap = gap_at(positions, view, point_along(search.ray, t), search.scale, true);
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
    step = step * 1.5f;
  }
  found.guess = regula_falsi(found);
  return found;
}

// The secant from the surface under the start. Where that has not ended on a surface, it goes on; where it
// has lost the surface (which is seen as a narrow strip, and guesses leap over it), from a bracket found by
// steps, if there can be one.
Hit intersect_secant(Texture positions, IN(View) view, IN(Search) search) {
  Bracket first = bracket_at_start(positions, view, search);
  Bracket from = first;
  Hit hit = close_in(positions, view, search, from);
  if (!search.beyond_is_behind) {
    Bool lost = search.reach > 0.0f && !is_met(hit, positions, view, point_along(search.ray, hit.distance));
    if (any_lane(lost)) {
      Bracket found = bracket_by_steps(positions, view, search, first);
      Bool near = hit.inside && hit.covered && from.bracketed;
      Bool again = lost && (near || found.bracketed);
      from = chosen(near, from, found);
      Hit second = close_in(positions, view, search, from);
      again = again && (!near || second.residual < hit.residual);
      hit = chosen(again, second, hit);
    }
  }
  return hit;
}

// A point's distance from the middle of an impostor over the surface's in the same direction; 0 without a
// surface.
Float impostor_quotient(Gap gap) { return sel(gap.covered, gap.value + 1.0f, Float(0.0f)); }

// Distance impostors (Szirmay-Kalos, Aszodi, Lazanyi, Premecz 2005): the view is a cube around a point near
// the casters. q = |p| / D(p), the point's distance from there over the surface's in the same direction,
// passes 1 where the ray meets the surface, and is linear along the ray over any plane. Theirs are the start,
// exact where one plane lies in the ray's direction and in the start's, and the steps: with D of the ray's
// own direction from the start until the ray has once been too far, after that the secant between the last
// point before and the last behind.
Hit intersect_impostor(Texture positions, IN(View) view, Vec3 centre, IN(Ray) ray, int iterations) {
  Float reach = Float(view.far);
  Gap ahead = gap_at(positions, view, centre + ray.direction * reach, Float(1.0f), true);
  Float share = ahead.value + 1.0f;
  Bool sound = share > 1.0e-6f;
  Float along = sel(ahead.covered && sound, reach / sel(sound, share, Float(1.0f)), reach);
  Gap gap = gap_at(positions, view, ray.start, Float(1.0f), true);
  // A start at the very centre has no direction, and q = 0.
  Float q_under = impostor_quotient(gap);
  Float under = Float(0.0f);
  Float over = Float(0.0f);
  Float q_over = Float(1.0f);
  Bool overshot = Bool(false);
  Float d = max_of(along * (1.0f - q_under), 0.0f);
  Float q = Float(0.0f);
  for (int k = 0; k < iterations + 1; k++) {
    gap = gap_at(positions, view, point_along(ray, d), Float(1.0f), true);
    TRACE(distance, d);
    q = impostor_quotient(gap);
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
  Hit hit = hit_at(d, gap);
  hit.residual = abs(q - 1.0f) * length3(point_along(ray, d) - centre);
  hit.inside = Bool(true);
  return hit;
}
