// How much of a stretch of the camera's ray the light's maps leave lit. Needs view_space.glsl and
// position_texel.glsl. A light in a medium that scatters has no cube.

// Of a depth where there is no surface.
#define NO_SURFACE 1.0e30f

// In the axes that all the light's views share, metres.
struct Stretch {
  Vec3 from;
  Vec3 to;
  Bool behind;  // it lies behind the light, where no map looks
  Bool ahead;   // all of it lies before the light
};

Stretch stretch_between(Vec3 from, Vec3 to) {
  Stretch s;
  s.from = from;
  s.to = to;
  s.behind = Bool(false);
  s.ahead = Bool(true);
  if (u.shadow_view.kind == VIEW_PERSPECTIVE) {
    s.behind = from.z <= 0.0f && to.z <= 0.0f;
    s.ahead = from.z > 0.0f && to.z > 0.0f;
  }
  return s;
}

// What a map holds along a stretch.
struct Bounds {
  Float lower;
  Float upper;
  Float extent;  // of the stretch in the map, along the side where it is longer, 0..1 of the map
};

Bounds bounds_of(Vec4 block, Float extent) {
  Bounds b;
  b.lower = block.x;
  b.upper = block.y;
  b.extent = extent;
  return b;
}

Bounds wider(IN(Bounds) b, Vec4 block) {
  Bounds result = b;
  result.lower = min_of(b.lower, block.x);
  result.upper = max_of(b.upper, block.y);
  return result;
}

Bool beside(Float a, Float b, float side) { return (a < 0.0f && b < 0.0f) || (a >= side && b >= side); }

// Longer stretches, in blocks, are not looked at: their parts are.
#define MOST_BLOCKS 8.0f

// From a map's blocks, all that the stretch touches. What lies outside of the map has the bound `outside`.
Bounds bounds_along(Texture blocks, IN(View) view, IN(Stretch) s, float outside) {
  float side = float(texture_width(blocks));
  Vec2 a = view_uv(view, s.from) * Float(side);
  Vec2 b = view_uv(view, s.to) * Float(side);
  Float extent = max_of(abs(b.x - a.x), abs(b.y - a.y));
  Bool no_part = s.behind || (s.ahead && (beside(a.x, b.x, side) || beside(a.y, b.y, side)));
  Bool known = s.ahead && extent < MOST_BLOCKS && !no_part;
  Int column = floor_to_int(a.x);
  Int row = floor_to_int(a.y);
  Bool more = known && (column != floor_to_int(b.x) || row != floor_to_int(b.y));
  Int pieces = sel(more, floor_to_int(extent) + 1, Int(0));
  Vec2 piece = (b - a) / max_of(Float(pieces), 1.0f);

  Bounds found = bounds_of(fetch_clamped(blocks, column, row), extent / side);
  for (int i = 1; any_lane(pieces >= i); i++) {
    Bool counts = pieces >= i;
    Int x = floor_to_int(a.x + piece.x * float(i));
    Int y = floor_to_int(a.y + piece.y * float(i));
    Bounds next = wider(found, fetch_clamped(blocks, x, y));
    Bool corner = counts && x != column && y != row;
    if (any_lane(corner)) {
      // Between two blocks that meet at a corner the piece goes through the one whose border it meets first.
      Vec2 from = a + piece * float(i - 1);
      Float to_x = abs(Float(max_of(x, column)) - from.x) * abs(piece.y);
      Bool x_first = to_x < abs(Float(max_of(y, row)) - from.y) * abs(piece.x);
      Bounds third = wider(next, fetch_clamped(blocks, sel(x_first, x, column), sel(x_first, row, y)));
      next.lower = sel(corner, third.lower, next.lower);
      next.upper = sel(corner, third.upper, next.upper);
    }
    found.lower = sel(counts, next.lower, found.lower);
    found.upper = sel(counts, next.upper, found.upper);
    column = x;
    row = y;
  }
  Bool inside = inside_unit(a.x / side, a.y / side) && inside_unit(b.x / side, b.y / side);
  found.lower = sel(known, min_of(found.lower, outside), sel(no_part, Float(outside), Float(-NO_SURFACE)));
  found.upper = sel(no_part, Float(outside), sel(known && inside, found.upper, Float(NO_SURFACE)));
  return found;
}

// What the maps' blocks say of a stretch.
struct Verdict {
  Bool dark;     // nothing of it is lit
  Bool even;     // all of it is lit alike
  Bool tinted;   // panes leave more of the light here than there
  Float texels;  // else: over so many of a map's texels it goes
};

// Takes in one map of depths, `nearest` and `farthest` the stretch's own.
Verdict judged(IN(Verdict) before, IN(Bounds) map, Vec2 depths, Texture texels) {
  Verdict v = before;
  Bool shadows = map.lower < depths.y;
  v.dark = before.dark || map.upper < depths.x;
  v.even = before.even && !shadows;
  v.texels = sel(shadows, max_of(before.texels, map.extent * float(texture_width(texels))), before.texels);
  return v;
}

// Tints differ by less within what counts as even.
#define EVEN_TINT 0.03f

Verdict verdict_on(IN(Stretch) s) {
  Verdict v;
  v.dark = Bool(false);
  v.even = Bool(true);
  v.tinted = Bool(false);
  v.texels = Float(0.0f);
  Vec2 depths = Vec2(min_of(s.from.z, s.to.z), max_of(s.from.z, s.to.z));
  if (u.has_shadow_map != 0) {
    v = judged(v, bounds_along(shadow_bounds, u.shadow_view, s, NO_SURFACE), depths, shadow_depth);
  }
  if (u.has_caustic != 0 && any_lane(!v.dark)) {
    v = judged(v, bounds_along(caster_bounds, u.caster_view, s, NO_SURFACE), depths, caster_position);
  }
  if (u.has_panes != 0 && any_lane(!v.dark)) {
    Bounds tint = bounds_along(pane_bounds, u.pane_view, s, 0.0f);
    v.tinted = tint.upper - tint.lower > EVEN_TINT;
    v.even = v.even && !v.tinted;
    v.texels =
        sel(v.tinted, max_of(v.texels, tint.extent * float(texture_width(pane_transmittance))), v.texels);
  }
  return v;
}

// The nearest depth that a surface has where the maps see q.
Float first_depth(Vec3 q) {
  Float first = Float(NO_SURFACE);
  if (u.has_shadow_map != 0) {
    Vec2 uv = view_uv(u.shadow_view, q);
    first = sel(inside_unit(uv.x, uv.y), fetch_nearest(shadow_depth, uv.x, uv.y).x, first);
  }
  if (u.has_caustic != 0) {
    Vec2 uv = view_uv(u.caster_view, q);
    Bool inside = inside_unit(uv.x, uv.y);
    if (any_lane(inside)) {
      Vec4 caster = fetch_nearest(caster_position, uv.x, uv.y);
      Float depth = view_coordinates(u.caster_view, Vec3(caster)).z;
      first = sel(inside && is_covered(caster), min_of(first, depth), first);
    }
  }
  return first;
}

// What panes leave.
Vec3 pane_tint(Vec3 q) {
  Vec3 tint = Vec3(1.0f);
  if (u.has_panes != 0) {
    Vec2 uv = view_uv(u.pane_view, q);
    tint = sel(inside_unit(uv.x, uv.y), Vec3(fetch_bilinear(pane_transmittance, uv.x, uv.y)), tint);
  }
  return tint;
}

// What a light without distance leaves of its light along a stretch: the mean, and where the middle of it
// lies, 0..1 along the stretch.
struct Lit {
  Vec3 share;
  Float middle;
};

// A stretch over more texels is divided.
#define MOST_TEXELS 12.0f

// By so many equal parts. Before one texel the depth changes evenly, and passes the
// surface's at one point.
Lit lit_parts(IN(Stretch) s, Bool tinted, Float parts) {
  Vec3 part = (s.to - s.from) / parts;
  Vec3 even_tint = pane_tint((s.from + s.to) * 0.5f);
  Vec3 sum = Vec3(0.0f);
  Float lit = Float(0.0f);
  Float moment = Float(0.0f);
  for (int i = 0; any_lane(parts > float(i)); i++) {
    Vec3 middle = s.from + part * (float(i) + 0.5f);
    Float surface = first_depth(middle);
    Float rise = abs(part.z);
    Bool moves = rise > 0.0f;
    Float passed = (surface - middle.z) / sel(moves, rise, Float(1.0f)) + 0.5f;
    Float share =
        sel(moves, clamp_to(passed, 0.0f, 1.0f), sel(surface < middle.z, Float(0.0f), Float(1.0f)));
    share = sel(parts > float(i), share, Float(0.0f));
    Vec3 tint = even_tint;
    Bool differs = tinted && share > 0.0f;
    if (any_lane(differs)) tint = sel(differs, pane_tint(middle), tint);
    sum = sum + tint * share;
    lit = lit + share;
    moment = moment + share * (float(i) + sel(part.z < 0.0f, 1.0f - share * 0.5f, share * 0.5f));
  }
  Lit result;
  result.share = sum / parts;
  result.middle = sel(lit > 0.0f, moment / (sel(lit > 0.0f, lit, Float(1.0f)) * parts), Float(0.5f));
  return result;
}

// By parts where there are any; without, all of it is lit.
Lit lit_along(IN(Stretch) s, Bool tinted, Float parts) {
  Lit lit;
  lit.share = pane_tint((s.from + s.to) * 0.5f);
  lit.middle = Float(0.5f);
  Bool divided = parts > 0.0f;
  if (any_lane(divided)) {
    Lit found = lit_parts(s, tinted, max_of(parts, 1.0f));
    lit.share = sel(divided, found.share, lit.share);
    lit.middle = sel(divided, found.middle, lit.middle);
  }
  return lit;
}
