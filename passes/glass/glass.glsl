// Glass, water and metal as the camera sees them: what lies behind, bent at both surfaces and tinted on the
// way, and what the first surface mirrors. glass.md explains.
UNIFORMS_BEGIN
#include "passes/glass/glass_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, scene_color)
TEXTURE(1, view_position)
TEXTURE(2, wide_color)
TEXTURE(3, wide_position)
TEXTURE(4, view_caster_position)
TEXTURE(5, view_caster_normal)
TEXTURE(6, view_exit_position)
TEXTURE(7, view_exit_normal)
TEXTURE(8, caster_materials)
TEXTURE(9, environment)
TEXTURE(10, view_caster_tint)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, beauty)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/intersect.glsl"
#include "passes/shared/sky.glsl"

// How far a ray may end before or behind a surface and still count as having met it, metres: eight texels'
// extents, because a surface that is seen from the side is known coarsely.
Bool meets(Hit hit, Vec3 start, Vec3 direction, Texture positions, vec4 window, vec4 depth) {
  Vec3 q = view_coordinates(u.from_scene, start + direction * hit.distance);
  Float extent = view_w(q, depth) / (window.x * float(texture_width(positions)));
  return hit.inside && !hit.left && hit.covered && hit.residual <= 8.0f * extent && hit.distance > 0.0f &&
         view_w(q, depth) > 0.0f;
}

// Radiance along a ray that starts outside the glass: the surface it meets on the screen, else one in
// the wide view around it, else the sky.
Vec3 radiance_along(Vec3 start, Vec3 direction) {
  Vec3 color = sky_radiance(direction);
  Hit hit = intersect_secant(wide_position, u.from_scene, u.wide_window, u.wide_depth, start, direction,
                             u.method.x, false);
  Vec2 uv = view_uv(view_coordinates(u.from_scene, start + direction * hit.distance),
                     u.wide_window, u.wide_depth);
  color = sel(meets(hit, start, direction, wide_position, u.wide_window, u.wide_depth),
              Vec3(fetch_bilinear(wide_color, uv.x, uv.y)), color);
  hit = intersect_secant(view_position, u.from_scene, u.window, u.depth, start, direction, u.method.x,
                         false);
  uv = view_uv(view_coordinates(u.from_scene, start + direction * hit.distance), u.window, u.depth);
  return sel(meets(hit, start, direction, view_position, u.window, u.depth),
             Vec3(fetch_bilinear(scene_color, uv.x, uv.y)), color);
}

Vec3 exit_normal_at(Vec3 p, Vec3 fallback) {
  Vec2 uv = view_uv(view_coordinates(u.from_scene, p), u.window, u.depth);
  Vec4 smooth_normal = fetch_bilinear(view_exit_normal, uv.x, uv.y);
  Vec4 nearest = fetch_nearest(view_exit_normal, uv.x, uv.y);
  return normalize_or(sel(smooth_normal.w > 0.999f, Vec3(smooth_normal), Vec3(nearest)), fallback);
}

// Radiance that a glass surface sends to the camera.
Vec3 through_glass(Vec4 entry, Vec4 entry_normal) {
  Vec3 p1 = Vec3(entry);
  Vec3 d0 = Vec3(u.forward);
  if (u.eye.w > 0.5f) d0 = normalize_or(p1 - Vec3(u.eye), Vec3(u.forward));
  Bool from_inside = entry.w < 0.0f;
  Int material = floor_to_int(entry_normal.w + 0.5f);
  Vec4 indices = fetch_clamped(caster_materials, Int(0), material);
  Vec4 absorption = fetch_clamped(caster_materials, Int(1), material);
  Vec3 tint = Vec3(fetch_clamped(caster_materials, Int(2), material));
  if (u.method.y == 1) tint = Vec3(texel_fetch(view_caster_tint, floor_to_int(frag_x()), floor_to_int(frag_y())));
  Float ior = indices.x;
  Bool solid = absorption.w > 0.5f && !from_inside;

  Vec3 n1 = facing_normal(Vec3(entry_normal), d0, from_inside);
  Float eta1 = sel(from_inside, ior, 1.0f / ior);
  Float ci1 = clamp_to(-dot3(d0, n1), 0.0f, 1.0f);
  Float ct1_squared = transmitted_cosine_squared(eta1, ci1);
  Float ct1 = sqrt(max_of(ct1_squared, 0.0f));
  Float r1 = sel(ct1_squared < 0.0f, Float(1.0f), fresnel_reflectance(eta1, ci1, ct1));
  Vec3 d1 = refracted(d0, n1, eta1, ci1, ct1);

  Hit exit = intersect_secant(view_exit_position, u.from_scene, u.window, u.depth, p1, d1, u.method.x,
                              true);
  Float inside_length = sel(solid, max_of(exit.distance, 0.0f), Float(0.0f));
  Vec3 p2 = p1 + d1 * inside_length;
  Vec3 n2 = facing_normal(exit_normal_at(p2, -d1), d1, Bool(true));
  Float ci2 = clamp_to(-dot3(d1, n2), 0.0f, 1.0f);
  Float ct2_squared = transmitted_cosine_squared(ior, ci2);
  Bool trapped = solid && ct2_squared < 0.0f;
  Float ct2 = sqrt(max_of(ct2_squared, 0.0f));
  // What cannot leave is mirrored inside once and then followed straight on.
  Vec3 leaving = sel(trapped, reflected(d1, n2, ci2), refracted(d1, n2, ior, ci2, ct2));
  Vec3 d2 = sel(solid, leaving, d1);
  Float r2 = sel(solid && !trapped, fresnel_reflectance(ior, ci2, ct2), Float(0.0f));

  Vec3 behind = radiance_along(p2, d2) * tint * transmittance(Vec3(absorption), inside_length);
  Vec3 mirrored = radiance_along(p1, reflected(d0, n1, ci1));
  Vec3 metal = mirrored * metal_reflectance(tint, ci1);
  // The share that the second surface sends back is taken to leave as it would have: nothing is lost to black.
  Vec3 glass = mirrored * r1 + behind * (1.0f - r1) * (1.0f - 0.5f * r2);
  return sel(indices.w > 0.5f, metal, glass);
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 entry = texel_fetch(view_caster_position, column, row);
  Vec4 entry_normal = texel_fetch(view_caster_normal, column, row);
  Vec4 surface = texel_fetch(view_position, column, row);
  Float z = view_coordinates(u.from_scene, Vec3(entry)).z;
  Float surface_z = view_coordinates(u.from_scene, Vec3(surface)).z;
  Bool seen = entry.w != 0.0f && (surface.w == 0.0f || z < surface_z);
  Vec3 color = Vec3(texel_fetch(scene_color, column, row));
  if (any_lane(seen)) color = sel(seen, through_glass(entry, entry_normal), color);
  beauty = Vec4(color, Float(1.0f));
}
#endif
