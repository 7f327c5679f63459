// What the medium scatters towards the camera of one light's direct light: a sum of steps along the camera's ray.
UNIFORMS_BEGIN
#include "passes/medium/view_ray_uniforms.glsl"
#include "passes/medium/medium_uniforms.glsl"
#include "passes/medium/light_haze_uniforms.glsl"
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
#include "passes/shared/light_intensity.glsl"
#include "passes/shared/optics.glsl"
#include "passes/medium/medium.glsl"
#include "passes/medium/view_ray.glsl"

// The mean of exp(-t) for t from t0 to t1, with exp(-t0) and exp(-t1) known.
Float mean_between(Float t0, Float t1, Float e0, Float e1) {
  Float rise = t1 - t0;
  // (1 - exp(-x)) / x as a series, where the difference of two nearly equal numbers has no digits.
  Float series = 1.0f - rise * (0.5f - rise * (1.0f / 6.0f - rise * (1.0f / 24.0f - rise * (1.0f / 120.0f))));
  Bool small = abs(rise) < 0.1f;
  return sel(small, e0 * series, (e0 - e1) / sel(small, Float(1.0f), rise));
}

Vec3 mean_transmittance(Float from, Float to, Vec3 e0, Vec3 e1) {
  Vec3 x = Vec3(u.extinction);
  Vec3 mean = Vec3(mean_between(from * x.x, to * x.x, e0.x, e1.x));
  if (u.medium_upper.w < 0.5f) {
    mean.y = mean_between(from * x.y, to * x.y, e0.y, e1.y);
    mean.z = mean_between(from * x.z, to * x.z, e0.z, e1.z);
  }
  return mean;
}

// What reaches a point of a light without distance: 0 in the shadow of opaque surfaces and behind casters, whose
// light goes other ways; what panes leave, elsewhere.
Vec3 visibility(Vec3 p) {
  Vec3 q = view_coordinates(u.light_from_scene, p);
  Vec3 seen = Vec3(1.0f);
  if (u.uses.z > 0.5f) {
    Vec2 uv = view_uv(q, u.pane_window, u.pane_depth);
    seen = sel(inside_unit(uv.x, uv.y), Vec3(fetch_bilinear(pane_transmittance, uv.x, uv.y)), seen);
  }
  if (u.uses.x > 0.5f) {
    Vec2 uv = view_uv(q, u.shadow_window, u.shadow_range);
    Bool blocked = inside_unit(uv.x, uv.y) && fetch_nearest(shadow_depth, uv.x, uv.y).x < q.z;
    seen = sel(blocked, Vec3(0.0f), seen);
  }
  if (u.uses.y > 0.5f) {
    Vec2 uv = view_uv(q, u.caster_window, u.caster_depth);
    Vec4 caster = fetch_nearest(caster_position, uv.x, uv.y);
    Bool blocked = inside_unit(uv.x, uv.y) && caster.w != 0.0f &&
                   view_coordinates(u.light_from_scene, Vec3(caster)).z < q.z;
    seen = sel(blocked, Vec3(0.0f), seen);
  }
  return seen;
}

// The integral of 1 / r^2 along a piece of the ray, exactly: the angle under which the light sees it, over the
// ray's distance from the light.
Float inverse_square(Vec3 from, Vec3 to, Float miss, Float length) {
  Float across = miss * length;
  return atan2_of(across, dot3(from - Vec3(u.light), to - Vec3(u.light))) / max_of(miss, 1.0e-20f);
}

// Falloff of a light with a position: its cone, and KHR_lights_punctual's window 1 - (d / range)^4.
Float falloff(Vec3 path) {
  Float result = cone_falloff(normalize_or(path, Vec3(u.cone_axis)));
  if (u.intensity.w > 0.0f) {
    Float s = dot3(path, path) / (u.intensity.w * u.intensity.w);
    result = result * clamp_to(1.0f - s * s, 0.0f, 1.0f);
  }
  return result;
}

void main() {
  Vec4 range = texel_fetch(view_range, floor_to_int(frag_x()), floor_to_int(frag_y()));
  Vec3 origin = view_ray_origin();
  Vec3 direction = view_ray_direction();
  bool positional = u.light.w > 0.5f;
  Float stride = (range.z - range.y) / float(u.steps.x);
  Vec3 travel = Vec3(u.light);
  Float weight = stride * phase_function(-dot3(travel, direction));
  // How near the ray passes a light with a position; no nearer than a ten thousandth of its way counts.
  Float miss = Float(0.0f);
  if (positional) {
    Vec3 to_light = Vec3(u.light) - origin;
    miss = max_of(length3(cross3(to_light, direction)), (range.z - range.y) * 1.0e-4f);
  }

  Vec3 sum = Vec3(0.0f);
  Vec3 here = origin + direction * range.y;
  Float way = light_way(here, travel, Vec3(u.light), positional);
  Vec3 left = medium_transmittance(way);
  for (int k = 1; k <= u.steps.x; k++) {
    Vec3 next = origin + direction * (range.y + stride * float(k));
    Float next_way = stride * float(k) + light_way(next, travel, Vec3(u.light), positional);
    Vec3 next_left = medium_transmittance(next_way);
    Vec3 middle = (here + next) * 0.5f;
    if (positional) {
      Vec3 path = middle - Vec3(u.light);
      weight = inverse_square(here, next, miss, stride) * falloff(path) *
               phase_function(-dot3(normalize_or(path, Vec3(u.cone_axis)), direction));
    }
    sum = sum + visibility(middle) * mean_transmittance(way, next_way, left, next_left) * weight;
    here = next;
    way = next_way;
    left = next_left;
  }
  haze = Vec4(Vec3(u.intensity) * Vec3(u.scattering) * sum, Float(0.0f));
}
#endif
