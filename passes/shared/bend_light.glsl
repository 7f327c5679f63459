// What befalls light at a caster's surface. Needs absorption.glsl, caster_material.glsl,
// caster_triangles.glsl, interface.glsl, light_path.glsl, media.glsl, optics.glsl, refraction.glsl, the
// uniforms of bend_light_uniforms.glsl, and the outputs of ray_outputs.glsl.

// The ways that light can take, and the one that it does.
struct Ways {
  Vec3 normal;       // smooth, against the light
  Refraction bent;
  Float eta;
  Float mirrored;    // share
  Bool goes;         // this branch goes on from here
  Bool is_mirrored;  // by being mirrored
  Vec3 flux;
  Vec3 booked;       // what nobody follows
};

// Unless it is said which way the branch takes, the stronger one; total reflection leaves no choice.
void choose_way(IN(LightPath) path, IN(Material) material, IN(Interface) both, INOUT(Ways) ways) {
  Float most = max_of(max_of(path.flux.x, path.flux.y), path.flux.z);
  Float least = u.least_share * path.whole;
  Bool one_way = material.mirror || both.passes || ways.bent.total;
  Bool is_followed = u.both_ways != 0 && most * ways.mirrored >= least;
  if (u.follows_mirrored != 0) {
    ways.goes = !one_way && is_followed;
    ways.is_mirrored = Bool(true);
    ways.flux = path.flux * ways.mirrored;
    ways.booked = Vec3(0.0f);
  } else {
    Bool stronger = u.both_ways == 0 && ways.mirrored > 0.5f;
    ways.goes = Bool(true);
    ways.is_mirrored = !both.passes && (material.mirror || ways.bent.total || stronger);
    Vec3 back = path.flux * ways.mirrored;
    Vec3 through = path.flux - back;
    ways.flux = sel(one_way, path.flux, sel(stronger, back, through));
    ways.booked = sel(one_way || is_followed, Vec3(0.0f), sel(stronger, through, back));
  }
}

Ways ways_at(IN(LightPath) path, IN(Meeting) at, IN(Interface) both, IN(Material) material) {
  Ways ways;
  ways.normal = facing_normal(at.outward, path.ray.direction, !at.front);
  ways.eta = both.before / both.behind;
  ways.bent = refraction_at(path.ray.direction, ways.normal, ways.eta);
  ways.bent.total = ways.bent.total && !both.passes && !material.mirror;
  ways.mirrored = sel(ways.bent.total, Float(1.0f), ways.bent.reflectance * material.fresnel);
  choose_way(path, material, both, ways);
  return ways;
}

// Igehy 1999, equations 10 to 18: over the stretch to the surface, then there.
struct Differential {
  Vec3 width;
  Vec3 spread;
};

Vec3 moved_on_surface(IN(LightPath) path, IN(Meeting) at, Vec3 width, Vec3 spread) {
  Vec3 moved = width + spread * at.stretch;
  Float along = dot3(path.ray.direction, at.plane);
  Float steep = sel(abs(along) > 1.0e-3f, along, sel(along < 0.0f, Float(-1.0e-3f), Float(1.0e-3f)));
  return moved - path.ray.direction * (dot3(moved, at.plane) / steep);
}

Vec3 spread_behind(IN(LightPath) path, IN(Ways) ways, Vec3 spread, Vec3 turn) {
  Float closing = -(dot3(spread, ways.normal) + dot3(path.ray.direction, turn));
  Float ci = ways.bent.cosine;
  Vec3 back = spread + (ways.normal * closing + turn * ci) * 2.0f;
  Float squared = max_of(transmitted_cosine_squared(ways.eta, ci), 1.0e-6f);
  Float ct = sqrt(squared);
  Float mu = ct - ways.eta * ci;
  Float mu_turn = (ways.eta * ways.eta * ci / ct - ways.eta) * closing;
  Vec3 through = spread * ways.eta - (ways.normal * mu_turn + turn * mu);
  return sel(ways.is_mirrored, back, through);
}

// The path with what it meets here: a body and an event.
Float path_with(Float path, Float body, Float event) {
  Float longer = path * 251.0f + (body * 4.0f + event);
  return longer - 65521.0f * floor(longer / 65521.0f);
}

void write_ray(IN(LightPath) path, Bool goes, Float mark) {
  AxesAcross axes = axes_across(path.ray.direction);
  Vec3 start = path.ray.start;
  Vec3 direction = path.ray.direction;
  discard_if(!goes);
  ray_start = Vec4(start, mark);
  ray_direction = Vec4(direction, path.path);
  ray_flux = Vec4(path.flux, path.whole);
  ray_media = path.media;
  ray_width = bounded(dot3(path.width_x, axes.x), dot3(path.width_x, axes.y), dot3(path.width_y, axes.x),
                      dot3(path.width_y, axes.y));
  ray_spread = bounded(dot3(path.spread_x, axes.x), dot3(path.spread_x, axes.y), dot3(path.spread_y, axes.x),
                       dot3(path.spread_y, axes.y));
}

// Moves the path to the surface: its differential, and what the body has left of its flux. Returns what the
// body has taken.
Vec3 arrive(INOUT(LightPath) path, IN(Meeting) at) {
  Vec3 before = path.flux;
  path.flux = path.flux * left_by(path.media.x, at.stretch);
  path.width_x = moved_on_surface(path, at, path.width_x, path.spread_x);
  path.width_y = moved_on_surface(path, at, path.width_y, path.spread_y);
  path.ray.start = at.point;
  return before - path.flux;
}

void leave(INOUT(LightPath) path, IN(Meeting) at, IN(CasterTriangle) triangle, IN(Ways) ways) {
  Vec3 turn_x = normal_turn(triangle, at, path.width_x);
  Vec3 turn_y = normal_turn(triangle, at, path.width_y);
  Bool flip = dot3(ways.normal, at.outward) < 0.0f;
  path.spread_x = spread_behind(path, ways, path.spread_x, sel(flip, -turn_x, turn_x));
  path.spread_y = spread_behind(path, ways, path.spread_y, sel(flip, -turn_y, turn_y));
  Vec3 mirrored = reflected(path.ray.direction, ways.normal, ways.bent.cosine);
  path.ray.direction = sel(ways.is_mirrored, mirrored, ways.bent.direction);
}

// The event at a surface; `color`: what the body lets through of each channel, or metal mirrors straight on.
void bend_light(INOUT(LightPath) path, IN(Meeting) at, IN(CasterTriangle) triangle, IN(Material) material,
                Bool covered) {
  Vec3 taken = arrive(path, at);
  Interface both = interface_at(path.media, at, triangle, material);
  Ways ways = ways_at(path, at, both, material);
  Vec3 before = path.ray.direction;
  LightPath on = path;
  leave(on, at, triangle, ways);
  on.ray.direction = sel(both.passes, before, on.ray.direction);
  on.spread_x = sel(both.passes, path.spread_x, on.spread_x);
  on.spread_y = sel(both.passes, path.spread_y, on.spread_y);
  Vec3 metal = metal_reflectance(material.color, ways.bent.cosine);
  Bool tints = both.tints && !ways.is_mirrored && !both.passes;
  Vec3 color = sel(material.mirror, metal, sel(tints, material.color * material.transmitted, Vec3(1.0f)));
  on.flux = ways.flux * color;
  on.media = sel(ways.is_mirrored, path.media, both.media);
  Float event = sel(both.passes, Float(EVENT_PASSES),
                    sel(ways.is_mirrored, Float(EVENT_MIRRORED), Float(EVENT_CROSSES)));
  on.path = path_with(path.path, triangle.body, event);
  Float left = max_of(max_of(on.flux.x, on.flux.y), on.flux.z);
  Bool ends = left < u.least_share * path.whole || strays(on.ray.direction, at, before, ways.is_mirrored);
  ends = ends || (both.overflow && !ways.is_mirrored);
  Vec3 share = Vec3(u.channel_share);
  Vec3 absorbed = ways.flux - on.flux;
  if (u.follows_mirrored == 0) absorbed = absorbed + taken;
  landing_fresnel = Vec4(ways.booked * share, Float(0.0f));
  landing_absorbed = Vec4(absorbed * share, Float(0.0f));
  Float mark = at.number + 1.0f;
  mark = sel(ends, Float(RAY_ENDED), mark);
  write_ray(on, covered && ways.goes, mark);
}
