// What the medium scatters towards the camera of one light's direct light: a sum of steps along the camera's
// ray.
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

Vec3 mean_transmittance(IN(RayPoint) from, IN(RayPoint) to) {
  Vec3 x = Vec3(u.medium.extinction);
  Vec3 mean = Vec3(mean_between(from.way * x.x, to.way * x.x, from.left.x, to.left.x));
  if (u.medium.is_grey == 0) {
    mean.y = mean_between(from.way * x.y, to.way * x.y, from.left.y, to.left.y);
    mean.z = mean_between(from.way * x.z, to.way * x.z, from.left.z, to.left.z);
  }
  return mean;
}

// What reaches a point of a light without distance: 0 in the shadow of opaque surfaces and behind casters,
// whose light goes other ways; what panes leave, elsewhere.
Vec3 visibility(Vec3 p) {
  Vec3 q = view_coordinates(u.shadow_view, p);
  Vec3 seen = Vec3(1.0f);
  if (u.has_panes != 0) {
    Vec2 uv = view_uv(u.pane_view, q);
    seen = sel(inside_unit(uv.x, uv.y), Vec3(fetch_bilinear(pane_transmittance, uv.x, uv.y)), seen);
  }
  if (u.has_shadow_map != 0) {
    Vec2 uv = view_uv(u.shadow_view, q);
    Bool blocked = inside_unit(uv.x, uv.y) && fetch_nearest(shadow_depth, uv.x, uv.y).x < q.z;
    seen = sel(blocked, Vec3(0.0f), seen);
  }
  if (u.has_caustic != 0) {
    Vec2 uv = view_uv(u.caster_view, q);
    Vec4 caster = fetch_nearest(caster_position, uv.x, uv.y);
    Float caster_z = view_coordinates(u.caster_view, Vec3(caster)).z;
    Bool blocked = inside_unit(uv.x, uv.y) && is_covered(caster) && caster_z < q.z;
    seen = sel(blocked, Vec3(0.0f), seen);
  }
  return seen;
}

// The integral of 1 / r^2 along a piece of the ray, exactly: the angle under which the light sees it, over
// the ray's distance from the light.
Float inverse_square(Vec3 from, Vec3 to, Float miss, Float length) {
  Float across = miss * length;
  Vec3 light = Vec3(u.light.position);
  return atan2_of(across, dot3(from - light, to - light)) / max_of(miss, 1.0e-20f);
}

// How near the ray passes a light with a position; no nearer than a ten thousandth of its way counts.
Float distance_from_light(IN(Ray) ray, IN(ViewRange) range) {
  Vec3 to_light = Vec3(u.light.position) - ray.start;
  return max_of(length3(cross3(to_light, ray.direction)), (range.exit - range.entry) * 1.0e-4f);
}

// What a light with a position sends to a piece of the ray and the phase function turns towards the camera,
// times the piece's length.
Float weight_between(IN(Ray) ray, Vec3 from, Vec3 to, Float miss, Float length) {
  Vec3 path = (from + to) * 0.5f - Vec3(u.light.position);
  Vec3 travel = normalize_or(path, Vec3(u.light.cone.axis));
  return inverse_square(from, to, miss, length) * light_falloff(u.light, travel, dot3(path, path)) *
         phase_function(u.medium, -dot3(travel, ray.direction));
}

void main() {
  ViewRange range = fetch_view_range(view_range);
  Ray ray = camera_ray(u.camera);
  Float stride = (range.exit - range.entry) / float(u.steps);
  Float weight = stride * phase_function(u.medium, -dot3(Vec3(u.light.direction), ray.direction));
  Float miss = Float(0.0f);
  if (u.light.has_position != 0) miss = distance_from_light(ray, range);

  Vec3 sum = Vec3(0.0f);
  RayPoint here = point_on(ray, range.entry, Float(0.0f));
  for (int k = 1; k <= u.steps; k++) {
    RayPoint next = point_on(ray, range.entry, stride * float(k));
    if (u.light.has_position != 0) weight = weight_between(ray, here.position, next.position, miss, stride);
    Vec3 middle = (here.position + next.position) * 0.5f;
    sum = sum + visibility(middle) * mean_transmittance(here, next) * weight;
    here = next;
  }
  haze = Vec4(Vec3(u.light.intensity) * Vec3(u.medium.scattering) * sum, Float(0.0f));
}
#endif
