// Bends light at a caster's surface. Needs absorption.glsl, interface.glsl, light_path.glsl,
// microfacets.glsl, rough_surface.glsl, surface.glsl, and the uniforms bend, draws, has_rough, least_share
// and rough_from.

// At one surface of a branch's way.
struct Turn {
  Bool both_ways;  // what is mirrored here is followed by another branch
  Bool mirrored;   // this is that branch
  Float drawn;     // of the branch that draws: between 0 and 1,
  Float chance;    // and how often it parts here from the others at least
  Float facet;     // of rough glass: a whole number for the microfacet that the light meets,
  Vec2 slope;      // and how that leans, of width 1
};

// Light behind the surface, and what stays there.
struct BentLight {
  LightPath path;
  Bool goes;      // this branch goes on from here
  Bool ends;      // but is followed no further
  Bool drawn_back;  // it is mirrored where others go through, as has been drawn
  Vec3 booked;    // what is mirrored or let through, and nobody follows
  Vec3 absorbed;
#ifdef HAZE
  Vec3 taken_by_air;
#endif
};

void widen(INOUT(LightPath) path, Float wider) {
  path.width_x = path.width_x * wider;
  path.width_y = path.width_y * wider;
  path.spread_x = path.spread_x * wider;
  path.spread_y = path.spread_y * wider;
}

// The way that a branch takes, with its light, and what is booked of the other. Unless it is said, that is
// the stronger one; total reflection leaves no choice.
struct Way {
  Bool goes;
  Bool is_mirrored;
  Vec3 flux;
  Vec3 booked;
};

// One way is drawn, for the branch that follows what the others leave behind. As long as it has gone where
// they go, the weaker way is drawn more often than it has light, and weighted by as much less. Light that is
// drawn seldom stands for that of the vertices around it, and its footprint grows. It is booked as followed
// where it parts from the others.
Way drawn_way(IN(Surface) surface, IN(Material) material, IN(Turn) turn, INOUT(LightPath) path) {
  Bool both_ways = turn.both_ways && !path.aside;
  Bool parts_here = !both_ways && !path.parted;
  Float weaker = min_of(surface.mirrored, 1.0f - surface.mirrored);
  Float chance = sel(parts_here, max_of(weaker, turn.chance), weaker);
  Bool takes_weaker = !surface.one_way && turn.drawn < chance;
  Bool back = sel(takes_weaker, surface.mirrored <= 0.5f, surface.mirrored > 0.5f);
  Float weight = sel(takes_weaker, weaker / max_of(chance, 1.0e-20f), (1.0f - weaker) / (1.0f - chance));
  Float wider = 1.0f / sqrt(sel(takes_weaker, max_of(chance, 1.0f / 16.0f), 1.0f - chance));
  Way way;
  way.goes = Bool(true);
  way.is_mirrored = most_is_mirrored(surface, material, back);
  way.flux = sel(surface.one_way, path.flux, path.flux * weight);
  way.booked = sel(parts_here && takes_weaker, -way.flux, Vec3(0.0f));
  path.aside = path.aside || (both_ways && back && !surface.one_way);
  path.parted = path.parted || (parts_here && takes_weaker);
  widen(path, sel(surface.one_way, Float(1.0f), wider));
  return way;
}

Way way_of(IN(LightPath) path, IN(Surface) surface, IN(Material) material, IN(Turn) turn) {
  Float most = max_of(max_of(path.flux.x, path.flux.y), path.flux.z);
  Float least = u.least_share * path.whole;
  Bool is_followed = turn.both_ways && most * surface.mirrored >= least;
  Bool stronger = !turn.both_ways && surface.mirrored > 0.5f;
  Vec3 back = path.flux * surface.mirrored;
  Vec3 through = path.flux - back;
  Vec3 followed = sel(surface.one_way, path.flux, sel(stronger, back, through));
  Bool all_goes_on = turn.mirrored || surface.one_way || is_followed;
  Way way;
  way.goes = !turn.mirrored || (!surface.one_way && is_followed);
  way.is_mirrored = turn.mirrored || most_is_mirrored(surface, material, stronger);
  way.flux = sel(turn.mirrored, back, followed);
  way.booked = sel(all_goes_on, Vec3(0.0f), sel(stronger, through, back));
  return way;
}

// Igehy 1999, equations 10 to 18: over the stretch to the surface, then there.
Vec3 moved_on_surface(IN(LightPath) path, IN(Meeting) at, Vec3 width, Vec3 spread) {
  Vec3 moved = width + spread * at.stretch;
  Float along = dot3(path.ray.direction, at.plane);
  Float steep = sel(abs(along) > 1.0e-3f, along, sel(along < 0.0f, Float(-1.0e-3f), Float(1.0e-3f)));
  return moved - path.ray.direction * (dot3(moved, at.plane) / steep);
}

Vec3 spread_behind(IN(LightPath) path, IN(Surface) surface, Bool is_mirrored, Vec3 spread, Vec3 turned) {
  Float closing = -(dot3(spread, surface.normal) + dot3(path.ray.direction, turned));
  Float ci = surface.bent.cosine;
  Vec3 back = spread + (surface.normal * closing + turned * ci) * 2.0f;
  Float squared = max_of(transmitted_cosine_squared(surface.eta, ci), 1.0e-6f);
  Float ct = sqrt(squared);
  Float mu = ct - surface.eta * ci;
  Float mu_turn = (surface.eta * surface.eta * ci / ct - surface.eta) * closing;
  Vec3 through = spread * surface.eta - (surface.normal * mu_turn + turned * mu);
  return sel(is_mirrored, back, through);
}

// The path with what it meets here: a body and an event; and a microfacet, which no neighbour meets.
Float path_with(Float path, Float body, IN(Surface) surface, Bool is_mirrored, Float facet) {
  Float event = sel(surface.both.passes, Float(EVENT_PASSES),
                    sel(is_mirrored, Float(EVENT_MIRRORED), Float(EVENT_CROSSES)));
  Float longer = path * 251.0f + ((body * 4.0f + event) + facet);
  return longer - 65521.0f * floor(longer / 65521.0f);
}

// Moves the path to the surface: its differential, and what the body, or the air, has left of its flux.
// Returns what that has taken.
Vec3 arrive(INOUT(LightPath) path, IN(Meeting) at) {
  Vec3 before = path.flux;
  path.flux = path.flux * left_on_way(path.ray, path.media.x, at.stretch);
  path.width_x = moved_on_surface(path, at, path.width_x, path.spread_x);
  path.width_y = moved_on_surface(path, at, path.width_y, path.spread_y);
  path.ray.start = at.point;
  path.own = at.number;
  return before - path.flux;
}

// Microfacets spread light: beside the slopes that its vertices draw, by a width over each footprint, so that
// these overlie each other many times. It is added the way in which the light is wide.
void spread_by_facets(INOUT(LightPath) path, IN(Surface) surface, Bool like_a_mirror, Float width) {
  Vec3 n = surface.normal;
  Float ci = surface.bent.cosine;
  Float ct = sqrt(max_of(transmitted_cosine_squared(surface.eta, ci), 0.0f));
  Float turned = sel(like_a_mirror, 2.0f * ci, abs(ct - surface.eta * ci)) * (width * 1.0f);
  AxesAcross axes = axes_across(n);
  Vec3 x = normalize_or(path.width_x - n * dot3(path.width_x, n), axes.x);
  Vec3 y = cross3(n, x);
  path.spread_x = path.spread_x + x * turned;
  path.spread_y = path.spread_y + sel(dot3(y, path.width_y) < 0.0f, -y, y) * turned;
}

void turn_differential(INOUT(LightPath) path, IN(Meeting) at, IN(CasterTriangle) triangle,
                       IN(Surface) surface, Bool is_mirrored) {
  Vec3 turn_x = normal_turn(triangle, at, path.width_x);
  Vec3 turn_y = normal_turn(triangle, at, path.width_y);
  Bool flip = dot3(surface.normal, at.outward) < 0.0f;
  turn_x = sel(flip, -turn_x, turn_x);
  turn_y = sel(flip, -turn_y, turn_y);
  Vec3 spread_x = spread_behind(path, surface, is_mirrored, path.spread_x, turn_x);
  Vec3 spread_y = spread_behind(path, surface, is_mirrored, path.spread_y, turn_y);
  path.spread_x = sel(surface.both.passes, path.spread_x, spread_x);
  path.spread_y = sel(surface.both.passes, path.spread_y, spread_y);
}

BentLight bend_light(IN(LightPath) before, IN(Meeting) at, IN(CasterTriangle) triangle,
                     IN(Material) material, IN(Turn) turn) {
  BentLight bent;
  bent.path = before;
  Vec3 taken = arrive(bent.path, at);
  Vec3 from = before.ray.direction;
  Interface both = interface_at(before.media, at, triangle, material);
  Facet facet = facet_at(from, at, both, material, turn.slope);
  Surface surface = facet.surface;
  Way way = way_of(bent.path, surface, material, turn);
  if (u.draws != 0) way = drawn_way(surface, material, turn, bent.path);
  turn_differential(bent.path, at, triangle, surface, way.is_mirrored);
  bent.path.ray.direction = direction_behind(surface, from, way.is_mirrored);
  bent.path.flux = way.flux * color_behind(surface, material, way.is_mirrored);
  Float number = Float(0.0f);
  if (u.has_rough != 0) {
    spread_by_facets(bent.path, surface, way.is_mirrored || material.thin, facet.width);
    bent.path.flux = bent.path.flux * sent_by(facet, at, from, bent.path.ray.direction, way.is_mirrored);
    number = sel(facet.width > 0.0f, turn.facet, number);
  }
  bent.path.media = sel(way.is_mirrored, before.media, surface.both.media);
  bent.path.path = path_with(before.path, triangle.body, surface, way.is_mirrored, number);
  keep_across(bent.path);
  Float left = max_of(max_of(bent.path.flux.x, bent.path.flux.y), bent.path.flux.z);
  Bool astray = strays(bent.path.ray.direction, at, from, way.is_mirrored);
  Bool overflow = surface.both.overflow && !way.is_mirrored;
  bent.goes = way.goes;
  bent.ends = left < u.least_share * before.whole || astray || overflow;
  bent.booked = way.booked;
  bent.drawn_back = Bool(u.draws != 0) && way.is_mirrored && !surface.one_way;
  Vec3 absorbed = way.flux - bent.path.flux;
#ifdef HAZE
  Bool in_air = is_in_air(before.media.x);
  bent.taken_by_air = sel(!turn.mirrored && before.parted && in_air, taken, Vec3(0.0f));
  taken = sel(in_air, Vec3(0.0f), taken);
#endif
  absorbed = sel(turn.mirrored || !before.parted, absorbed, absorbed + taken);
  bent.absorbed = sel(bent.path.parted, absorbed, Vec3(0.0f));
  return bent;
}
