// How far each of the camera's rays goes through the medium.
#include "passes/shared/camera_rays.glsl"
#include "passes/shared/homogeneous_medium.glsl"
UNIFORMS_BEGIN
#include "passes/view_range/view_range_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, view_position)
TEXTURE(1, view_normal)
TEXTURE(2, view_caster_position)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, view_range)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/camera_ray.glsl"

struct FirstSurface {
  Float z;         // along the camera's axis, metres
  Float distance;  // along the ray, metres
};

// Opaque, or glass. What the picture lacks is one texel of zeros.
FirstSurface first_surface(IN(Ray) ray) {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 surface = texel_fetch(view_position, column, row);
  Bool seen = is_covered(surface);
  Float far = Float(1.0e30f);
  FirstSurface first;
  first.z = sel(seen, texel_fetch(view_normal, column, row).w, far);
  first.distance = sel(seen, dot3(Vec3(surface) - ray.start, ray.direction), far);
  Vec4 caster = fetch_clamped(view_caster_position, column, row);
  Float caster_z = view_coordinates(u.view, Vec3(caster)).z;
  Bool glass = is_covered(caster) && caster_z < first.z;
  first.z = sel(glass, caster_z, first.z);
  first.distance = sel(glass, dot3(Vec3(caster) - ray.start, ray.direction), first.distance);
  return first;
}

// Narrows a range of distances, x to y, to where a ray is between two planes across an axis.
Vec2 within_slab(Vec2 range, Float p, Float d, float lower, float upper) {
  Float steep = sel(d >= 0.0f, max_of(d, 1.0e-20f), min_of(d, Float(-1.0e-20f)));
  Float a = (lower - p) / steep;
  Float b = (upper - p) / steep;
  return Vec2(max_of(range.x, min_of(a, b)), min_of(range.y, max_of(a, b)));
}

Vec2 within_medium(IN(Medium) medium, IN(Ray) ray, Float length) {
  Vec2 range = Vec2(Float(0.0f), length);
  range = within_slab(range, ray.start.x, ray.direction.x, medium.lower.x, medium.upper.x);
  range = within_slab(range, ray.start.y, ray.direction.y, medium.lower.y, medium.upper.y);
  return within_slab(range, ray.start.z, ray.direction.z, medium.lower.z, medium.upper.z);
}

void main() {
  Ray ray = camera_ray(u.camera);
  FirstSurface first = first_surface(ray);
  Vec2 range = within_medium(u.medium, ray, first.distance);
  // A ray that passes by the medium has no way in it. It must not be said to be where its planes are met: for
  // a ray along an axis that is so far away that squared distances overflow.
  Bool crosses = range.y > range.x;
  Float entry = sel(crosses, range.x, Float(0.0f));
  Float exit = sel(crosses, range.y, Float(0.0f));
  view_range = Vec4(first.z, entry, exit, Float(0.0f));
}
#endif
