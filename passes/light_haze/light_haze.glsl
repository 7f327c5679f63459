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

// How near the ray passes a light with a position; no nearer than its radius and a ten thousandth of the ray's
// way counts.
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

// Where a ray meets more edges than these budgets allow, it is divided less finely. It may be halved so often,
// and once more for each two steps that it has gone.
#define SPLITS_AT_ONCE 64.0f
// A stretch that is not halved has at most so many parts, a ray so many at once and a few more for each step.
#define MOST_PARTS 16.0f
#define PARTS_AT_ONCE 384.0f
#define PARTS_A_STEP 2.0f

void main() {
  ViewRange range = fetch_view_range(view_range);
  Ray ray = camera_ray(u.camera);
  Float miss = Float(0.0f);
  Vec2 reached = Vec2(range.entry, range.exit);
  if (u.light.has_position != 0) {
    miss = distance_from_light(ray, range);
    reached = reached_by_light(reached, ray);
  }
  float steps = float(u.steps);
  Float stride = max_of(reached.y - reached.x, 0.0f) / steps;
  Float toward = phase_function(u.medium, -dot3(Vec3(u.light.direction), ray.direction));
  Vec3 q_start = view_coordinates(u.shadow_view, point_along(ray, reached.x));
  Vec3 q_step = transform_vector(u.shadow_view.from_scene, ray.direction) * stride;
  Float beyond_entry = reached.x - range.entry;

  Vec3 sum = Vec3(0.0f);
  RayPoint here = point_on(ray, range.entry, beyond_entry);
  Bool here_stands = Bool(true);  // at the stretch's start
  float largest = 1.0f;
  // Without a position all but the way through the medium is integrated exactly.
  if (u.light.has_position == 0) largest = 4.0f;
  Float at = sel(stride > 0.0f, Float(0.0f), Float(steps));  // in steps
  Float size = Float(largest);
  Float splits = Float(0.0f);
  Float parts = Float(0.0f);
  for (int i = 0; any_lane(at < steps); i++) {
    Float end = min_of(at + size, Float(steps));
    Stretch s = stretch_between(q_start + q_step * at, q_start + q_step * end);
    Verdict v = verdict_on(s);
    Bool uneven = !v.dark && !v.even;
    Bool split = uneven && v.texels > MOST_TEXELS && size > 0.0005f && splits < at * 0.5f + SPLITS_AT_ONCE;
    Bool lit = at < steps && !split && !v.dark;
    if (any_lane(lit)) {
      if (any_lane(lit && !here_stands)) {
        RayPoint start = point_on(ray, range.entry, beyond_entry + stride * at);
        here.position = sel(here_stands, here.position, start.position);
        here.way = sel(here_stands, here.way, start.way);
        here.left = sel(here_stands, here.left, start.left);
      }
      RayPoint next = point_on(ray, range.entry, beyond_entry + stride * end);
      Lit seen;
      seen.share = pane_tint((s.from + s.to) * 0.5f);
      seen.middle = Float(0.5f);
      Bool divided = lit && uneven;
      if (any_lane(divided)) {
        Float left = max_of(PARTS_AT_ONCE + PARTS_A_STEP * at - parts, PARTS_A_STEP * (end - at));
        Float most = clamp_to(floor(left), 1.0f, MOST_PARTS);
        Float now = sel(divided, clamp_to(floor(v.texels) + 1.0f, 1.0f, most), Float(1.0f));
        Lit found = lit_parts(s, v.tinted, now);
        seen.share = sel(divided, found.share, seen.share);
        seen.middle = sel(divided, found.middle, seen.middle);
        parts = sel(divided, parts + now, parts);
      }
      Float weight = toward * (stride * (end - at));
      if (u.light.has_position != 0) {
        weight = weight_between(ray, here.position, next.position, miss, seen.middle);
      }
      sum = sum + sel(lit, seen.share * mean_transmittance(here, next, seen.middle) * weight, Vec3(0.0f));
      here.position = sel(lit, next.position, here.position);
      here.way = sel(lit, next.way, here.way);
      here.left = sel(lit, next.left, here.left);
    }
    here_stands = (here_stands && split) || lit;
    at = sel(split, at, end);
    size = sel(split, size * 0.5f, size);
    for (int k = 0; k < 2; k++) {
      Bool whole = floor(at / (size * 2.0f)) * (size * 2.0f) == at;
      size = sel(!split && whole && size < largest, size * 2.0f, size);
    }
    splits = sel(split, splits + 1.0f, splits);
  }
  haze = Vec4(Vec3(u.light.intensity) * Vec3(u.medium.scattering) * sum, Float(0.0f));
}
#endif
