// How far each of the camera's rays goes through the medium, and what the medium leaves of what it ends on.
UNIFORMS_BEGIN
#include "passes/medium/view_ray_uniforms.glsl"
#include "passes/medium/medium_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, view_position)
TEXTURE(1, view_normal)
TEXTURE(2, view_caster_position)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, beauty)
OUTPUT(1, Vec4, view_range)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/optics.glsl"
#include "passes/medium/medium.glsl"
#include "passes/medium/view_ray.glsl"

// Narrows a range of distances, x to y, to where a ray is between two planes across an axis.
Vec2 within_slab(Vec2 range, Float p, Float d, float lower, float upper) {
  Float steep = sel(d >= 0.0f, max_of(d, 1.0e-20f), min_of(d, Float(-1.0e-20f)));
  Float a = (lower - p) / steep;
  Float b = (upper - p) / steep;
  return Vec2(max_of(range.x, min_of(a, b)), min_of(range.y, max_of(a, b)));
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec3 origin = view_ray_origin();
  Vec3 direction = view_ray_direction();

  // The first surface: opaque, or glass. What the frame lacks is one texel of zeros.
  Vec4 surface = texel_fetch(view_position, column, row);
  Float far = Float(1.0e30f);
  Float z = sel(surface.w != 0.0f, texel_fetch(view_normal, column, row).w, far);
  Float distance = sel(surface.w != 0.0f, dot3(Vec3(surface) - origin, direction), far);
  Vec4 caster = fetch_clamped(view_caster_position, column, row);
  Float caster_z = view_coordinates(u.from_scene, Vec3(caster)).z;
  Bool glass = caster.w != 0.0f && caster_z < z;
  z = sel(glass, caster_z, z);
  distance = sel(glass, dot3(Vec3(caster) - origin, direction), distance);

  Vec2 range = Vec2(Float(0.0f), distance);
  range = within_slab(range, origin.x, direction.x, u.medium_lower.x, u.medium_upper.x);
  range = within_slab(range, origin.y, direction.y, u.medium_lower.y, u.medium_upper.y);
  range = within_slab(range, origin.z, direction.z, u.medium_lower.z, u.medium_upper.z);
  // A ray that passes by the medium has no way in it. It must not be said to be where its planes are met: for a ray along
  // an axis that is so far away that squared distances overflow.
  Bool crosses = range.y > range.x;
  Float start = sel(crosses, range.x, Float(0.0f));
  Float end = sel(crosses, range.y, Float(0.0f));
  beauty = Vec4(medium_transmittance(end - start), Float(1.0f));
  view_range = Vec4(z, start, end, Float(0.0f));
}
#endif
