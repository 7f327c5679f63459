// What a cell gives to one texel: of both its triangles the flux times the share of the area that lies on the
// texel.
OUTPUT(0, Vec4, caustic_map)

// The mean of clamp(y, 0, 1) on the way from y0 to y1.
Float mean_clamped(Float y0, Float y1) {
  Float low = min_of(y0, y1);
  Float high = max_of(y0, y1);
  Float from = clamp_to(low, 0.0f, 1.0f);
  Float to = clamp_to(high, 0.0f, 1.0f);
  Float range = high - low;
  Bool sloped = range > 1.0e-12f;
  Float above = max_of(high - max_of(low, 1.0f), 0.0f);
  Float sum = (from + to) * 0.5f * (to - from) + above;
  return sel(sloped, sum / sel(sloped, range, Float(1.0f)), from);
}

// The area between an edge and the bottom of the unit square, inside the square, positive where the edge
// runs to the right. Over the edges of a polygon these add up to minus its area inside the square when it
// winds counter-clockwise.
Float area_below(Vec2 p, Vec2 q) {
  Float x0 = clamp_to(p.x, 0.0f, 1.0f);
  Float x1 = clamp_to(q.x, 0.0f, 1.0f);
  Float run = q.x - p.x;
  Float slope = (q.y - p.y) / sel(run != 0.0f, run, Float(1.0f));
  Float y0 = p.y + (x0 - p.x) * slope;
  Float y1 = q.y + (x1 - q.x) * slope;
  return sel(run != 0.0f, (x1 - x0) * mean_clamped(y0, y1), Float(0.0f));
}

Float twice_area(Vec2 a, Vec2 b, Vec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Float squared_length(Vec2 v) { return v.x * v.x + v.y * v.y; }

// Too thin for a quotient of areas: a height of less than 1/256 texel.
Bool is_sliver(Float twice, Float longest_squared) {
  return twice * twice <= longest_squared * (1.0f / 65536.0f);
}

// Where the line p + t (q - p), 0 <= t <= 1, enters and leaves 0 <= x < 1 along one axis.
Vec2 inside_slab(Float p, Float q) {
  Float run = q - p;
  Bool moves = abs(run) > 1.0e-20f;
  Float safe = sel(moves, run, Float(1.0f));
  Float at_zero = clamp_to((0.0f - p) / safe, 0.0f, 1.0f);
  Float at_one = clamp_to((1.0f - p) / safe, 0.0f, 1.0f);
  Bool inside = p >= 0.0f && p < 1.0f;
  return sel(moves, Vec2(min_of(at_zero, at_one), max_of(at_zero, at_one)),
             Vec2(Float(0.0f), sel(inside, Float(1.0f), Float(0.0f))));
}

// Share of a triangle without height between its end and t, its third corner at s: its width grows to s
// and shrinks again.
Float tent(Float t, Float s) {
  Float rising = t * t / max_of(s, 1.0e-6f);
  Float falling = 1.0f - (1.0f - t) * (1.0f - t) / max_of(1.0f - s, 1.0e-6f);
  return sel(t < s, rising, falling);
}

// Share of a sliver that lies on the unit square: it is taken for the line of its longest edge.
Float sliver_share(Vec2 a, Vec2 b, Vec2 c) {
  Float ab = squared_length(b - a);
  Float bc = squared_length(c - b);
  Float ca = squared_length(a - c);
  Bool ab_longest = ab >= bc && ab >= ca;
  Bool bc_longest = !ab_longest && bc >= ca;
  Vec2 p = sel(ab_longest, a, sel(bc_longest, b, c));
  Vec2 q = sel(ab_longest, b, sel(bc_longest, c, a));
  Vec2 third = sel(ab_longest, c, sel(bc_longest, a, b));
  Float squared = max_of(max_of(ab, bc), ca);
  Float s = ((third.x - p.x) * (q.x - p.x) + (third.y - p.y) * (q.y - p.y)) /
            sel(squared > 1.0e-30f, squared, Float(1.0f));
  Vec2 across = inside_slab(p.x, q.x);
  Vec2 along = inside_slab(p.y, q.y);
  Float from = max_of(across.x, along.x);
  Float to = max_of(min_of(across.y, along.y), from);
  Float middle = clamp_to(s, 0.0f, 1.0f);
  return tent(to, middle) - tent(from, middle);
}

// Share of a triangle's area on the unit square, from minus the signed area inside it.
Float area_share(Float below, Float twice) { return clamp_to(-2.0f * below / twice, 0.0f, 1.0f); }

void main() {
  Vec2 origin = Vec2(frag_x() - 0.5f, frag_y() - 0.5f);
  Vec2 a = Vec2(near.x, near.y) - origin;
  Vec2 b = Vec2(near.z, near.w) - origin;
  Vec2 c = Vec2(far.x, far.y) - origin;
  Vec2 d = Vec2(far.z, far.w) - origin;
  Float twice1 = twice_area(a, b, c);
  Float twice2 = twice_area(d, c, b);
  Float bc_squared = squared_length(c - b);
  Bool thin1 = is_sliver(twice1, max_of(bc_squared, max_of(squared_length(b - a), squared_length(c - a))));
  Bool thin2 = is_sliver(twice2, max_of(bc_squared, max_of(squared_length(d - b), squared_length(d - c))));
  Float below_bc = area_below(b, c);
  Float below1 = area_below(a, b) + below_bc + area_below(c, a);
  Float below2 = area_below(d, c) - below_bc + area_below(b, d);
  Float share1 = area_share(below1, sel(thin1, Float(1.0f), twice1));
  Float share2 = area_share(below2, sel(thin2, Float(1.0f), twice2));
  if (any_lane(thin1 || thin2)) {
    share1 = sel(thin1, sliver_share(a, b, c), share1);
    share2 = sel(thin2, sliver_share(d, c, b), share2);
  }
  Float share = 0.5f * (share1 + share2);
  caustic_map = Vec4(flux * share, share);
}
