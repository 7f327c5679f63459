// What the medium scatters towards the camera of one light's direct light: a sum of stretches of the camera's
// ray, which are the shorter the more the light's maps change along them. light_haze.md explains.
#include "passes/shared/camera_rays.glsl"
#include "passes/shared/light_cone.glsl"
#include "passes/shared/light.glsl"
#include "passes/shared/homogeneous_medium.glsl"
UNIFORMS_BEGIN
#include "passes/light_haze/light_haze_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, view_range)
TEXTURE(1, shadow_depth)
TEXTURE(2, caster_position)
TEXTURE(3, pane_transmittance)
TEXTURE(4, shadow_bounds)
TEXTURE(5, caster_bounds)
TEXTURE(6, pane_bounds)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, haze)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/cone_falloff.glsl"
#include "passes/shared/light_falloff.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/camera_ray.glsl"
#include "passes/shared/medium_optics.glsl"
#include "passes/shared/light_way.glsl"
#include "passes/shared/view_range.glsl"
#include "passes/light_haze/light_reach.glsl"
#include "passes/light_haze/lit_stretch.glsl"

// A point on the camera's ray.
struct RayPoint {
  Vec3 position;
  Float way;  // from the light to here and on to where the ray enters the medium, metres of medium
  Vec3 left;  // transmittance over that way
};

RayPoint point_on(IN(Ray) ray, Float entry, Float beyond_entry) {
  RayPoint p;
  p.position = point_along(ray, entry + beyond_entry);
  p.way = beyond_entry + light_way(u.medium, u.light, p.position);
  p.left = medium_transmittance(u.medium, p.way);
  return p;
}

// The mean of exp(-t) for t from t0 to t1, with exp(-t0) and exp(-t1) known.
Float mean_between(Float t0, Float t1, Float e0, Float e1) {
  Float rise = t1 - t0;
  // (1 - exp(-x)) / x as a series, where the difference of two nearly equal numbers has no digits.
  Float series = 1.0f - rise * (0.5f - rise * (1.0f / 6.0f - rise * (1.0f / 24.0f - rise * (1.0f / 120.0f))));
  Bool small = abs(rise) < 0.1f;
  return sel(small, e0 * series, (e0 - e1) / sel(small, Float(1.0f), rise));
}

// Between two points, of light whose middle lies at a share of the way.
Vec3 mean_transmittance(IN(RayPoint) from, IN(RayPoint) to, Float middle) {
  Vec3 x = Vec3(u.medium.extinction);
  Vec3 mean = Vec3(mean_between(from.way * x.x, to.way * x.x, from.left.x, to.left.x));
  if (u.medium.is_grey == 0) {
    mean.y = mean_between(from.way * x.y, to.way * x.y, from.left.y, to.left.y);
    mean.z = mean_between(from.way * x.z, to.way * x.z, from.left.z, to.left.z);
  }
  return mean + (to.left - from.left) * (middle - 0.5f);
}

// The integral of 1 / r^2 along a piece of the ray, exactly: the angle under which the light sees it, over
// the ray's distance from the light.
Float inverse_square(Vec3 from, Vec3 to, Float miss, Float length) {
  Float across = miss * length;
  Vec3 light = Vec3(u.light.position);
  return atan2_of(across, dot3(from - light, to - light)) / max_of(miss, 1.0e-20f);
}

// How near the ray passes a light with a position; no nearer than its radius and a
// ten-thousandth of the stretch counts.
Float distance_from_light(IN(Ray) ray, IN(ViewRange) range) {
  Vec3 to_light = Vec3(u.light.position) - ray.start;
  Float least = max_of((range.exit - range.entry) * 1.0e-4f, Float(u.light.radius));
  return max_of(length3(cross3(to_light, ray.direction)), least);
}

// What a light with a position sends to a piece of the ray and the phase function turns towards the camera,
// times the piece's length. `middle`: where most of that lies, 0..1.
Float weight_between(IN(Ray) ray, Vec3 from, Vec3 to, Float miss, Float middle) {
  Vec3 path = from * (1.0f - middle) + to * middle - Vec3(u.light.position);
  Vec3 travel = normalize_or(path, Vec3(u.light.cone.axis));
  return inverse_square(from, to, miss, dot3(to - from, ray.direction)) *
         light_falloff(u.light, travel, dot3(path, path)) *
         phase_function(u.medium, -dot3(travel, ray.direction));
}

// Where a ray meets more edges than these budgets allow, it is divided less finely. It may be halved so
// often,
// and once more for each two steps that it has gone.
#define SPLITS_AT_ONCE 64.0f
// A stretch that is not halved has at most so many parts, a ray so many at once and a few more for each step.
#define MOST_PARTS 16.0f
#define PARTS_AT_ONCE 384.0f
#define PARTS_A_STEP 2.0f

// The part of the camera's ray that the light reaches.
struct Way {
  Ray ray;
  Float entry;         // of the ray into the medium, metres
  Float beyond_entry;  // where the part starts, from there
  Float stride;        // a step's length; 0 where no light reaches the ray
  Float miss;          // of a light with a position: how near the ray passes it
  Float toward;        // of other lights: the phase function
  Vec3 q_start;        // the part's start in the axes of the light's views, and a step
  Vec3 q_step;
};

Way reached_way() {
  ViewRange range = fetch_view_range(view_range);
  Way way;
  way.ray = camera_ray(u.camera);
  way.miss = Float(0.0f);
  Vec2 reached = Vec2(range.entry, range.exit);
  if (u.light.has_position != 0) {
    way.miss = distance_from_light(way.ray, range);
    reached = reached_by_light(reached, way.ray);
  }
  way.entry = range.entry;
  way.beyond_entry = reached.x - range.entry;
  way.stride = max_of(reached.y - reached.x, 0.0f) / float(u.steps);
  way.toward = phase_function(u.medium, -dot3(Vec3(u.light.direction), way.ray.direction));
  way.q_start = view_coordinates(u.shadow_view, point_along(way.ray, reached.x));
  way.q_step = transform_vector(u.shadow_view.from_scene, way.ray.direction) * way.stride;
  return way;
}

RayPoint at_step(IN(Way) way, Float at) {
  return point_on(way.ray, way.entry, way.beyond_entry + way.stride * at);
}

// How far a walk along the way has come, in steps.
struct Walk {
  Float at;
  Float end;   // of the stretch at hand
  Float size;  // of it, but for the last one
  Float splits;
  Float parts;
};

// Steps without a position are longer: all but the way through the medium is integrated exactly.
Float largest_size() {
  Float size = Float(1.0f);
  if (u.light.has_position == 0) size = Float(4.0f);
  return size;
}

Walk started(Float stride) {
  Walk w;
  w.at = sel(stride > 0.0f, Float(0.0f), Float(float(u.steps)));
  w.size = largest_size();
  w.end = min_of(w.at + w.size, Float(float(u.steps)));
  w.splits = Float(0.0f);
  w.parts = Float(0.0f);
  return w;
}

// The stretch's first half next, or what follows it, as large as its place among the steps allows.
Walk next_stretch(IN(Walk) before, Bool split) {
  Walk w = before;
  w.at = sel(split, before.at, before.end);
  w.size = sel(split, before.size * 0.5f, before.size);
  for (int k = 0; k < 2; k++) {
    Bool whole = floor(w.at / (w.size * 2.0f)) * (w.size * 2.0f) == w.at;
    w.size = sel(!split && whole && w.size < largest_size(), w.size * 2.0f, w.size);
  }
  w.end = min_of(w.at + w.size, Float(float(u.steps)));
  w.splits = sel(split, before.splits + 1.0f, before.splits);
  return w;
}

Bool is_to_be_split(IN(Walk) w, IN(Verdict) v) {
  Bool coarse = v.texels > MOST_TEXELS && w.size > 0.0005f;
  return !v.dark && !v.even && coarse && w.splits < w.at * 0.5f + SPLITS_AT_ONCE;
}

// Of a stretch that is not split.
Float parts_allowed(IN(Walk) w, IN(Verdict) v) {
  Float left = max_of(PARTS_AT_ONCE + PARTS_A_STEP * w.at - w.parts, PARTS_A_STEP * (w.end - w.at));
  return clamp_to(floor(v.texels) + 1.0f, 1.0f, clamp_to(floor(left), 1.0f, MOST_PARTS));
}

Vec3 scattered_between(IN(Way) way, IN(RayPoint) from, IN(RayPoint) to, IN(Lit) lit, Float steps) {
  Float weight = way.toward * (way.stride * steps);
  if (u.light.has_position != 0) {
    weight = weight_between(way.ray, from.position, to.position, way.miss, lit.middle);
  }
  return lit.share * mean_transmittance(from, to, lit.middle) * weight;
}

void main() {
  Way way = reached_way();
  Vec3 sum = Vec3(0.0f);
  RayPoint here = at_step(way, Float(0.0f));
  Bool here_stands = Bool(true);  // at the stretch's start
  Walk w = started(way.stride);
  for (int i = 0; any_lane(w.at < float(u.steps)); i++) {
    Stretch s = stretch_between(way.q_start + way.q_step * w.at, way.q_start + way.q_step * w.end);
    Verdict v = verdict_on(s);
    Bool split = is_to_be_split(w, v);
    Bool lit = w.at < float(u.steps) && !split && !v.dark;
    if (any_lane(lit)) {
      if (any_lane(lit && !here_stands)) {
        RayPoint start = at_step(way, w.at);
        here.position = sel(here_stands, here.position, start.position);
        here.way = sel(here_stands, here.way, start.way);
        here.left = sel(here_stands, here.left, start.left);
      }
      RayPoint next = at_step(way, w.end);
      Bool divided = lit && !v.even;
      Float parts = sel(divided, parts_allowed(w, v), Float(0.0f));
      Vec3 scattered = scattered_between(way, here, next, lit_along(s, v.tinted, parts), w.end - w.at);
      sum = sum + sel(lit, scattered, Vec3(0.0f));
      w.parts = w.parts + parts;
      here.position = sel(lit, next.position, here.position);
      here.way = sel(lit, next.way, here.way);
      here.left = sel(lit, next.left, here.left);
    }
    here_stands = (here_stands && split) || lit;
    w = next_stretch(w, split);
  }
  haze = Vec4(Vec3(u.light.intensity) * Vec3(u.medium.scattering) * sum, Float(0.0f));
}
#endif
