// Glass, water and metal as the camera sees them: what lies behind, bent at both surfaces and tinted on the
// way, and what the first surface mirrors. glass.md explains.
#include "passes/shared/sky_model.glsl"
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
TEXTURE(11, caster_highlight)
TEXTURE(12, layers)
TEXTURE(13, first_layer)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, beauty)
#include "passes/shared/caster_material.glsl"
#include "passes/shared/axes_across.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/layers_before_glass.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/receivers_box.glsl"
#include "passes/shared/refraction.glsl"
#include "passes/shared/microfacets.glsl"
#include "passes/shared/sky_radiance.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/intersect.glsl"

// How far a ray may end before or behind a surface and still count as having met it, metres: eight texels'
// extents, because a surface that is seen from the side is known coarsely.
Bool meets(IN(Hit) hit, IN(Ray) ray, Texture positions, IN(View) view) {
  Float w = view_w(view, view_coordinates(view, point_along(ray, hit.distance)));
  Float extent = w / (view.scale.x * float(texture_width(positions)));
  return hit.inside && !hit.left && hit.covered && hit.residual <= 8.0f * extent && hit.distance > 0.0f &&
         w > 0.0f;
}

// The surface that a ray meets in a view.
struct Met {
  Bool surface;
  Vec3 color;
  Float distance;  // metres
};

// Where a ray is `wanted`; elsewhere the search's second try is saved, and nobody may use what is found.
Met met_in(Texture colors, Texture positions, IN(View) view, IN(Ray) ray, Bool wanted) {
  Search search = search_along(view, ray, u.iterations, false);
  search.reach = sel(wanted, search.reach, Float(0.0f));
  Hit hit = intersect_secant(positions, view, search);
  Vec2 uv = view_uv(view, view_coordinates(view, point_along(ray, hit.distance)));
  Met met;
  met.surface = wanted && meets(hit, ray, positions, view);
  met.color = Vec3(fetch_bilinear(colors, uv.x, uv.y));
  met.distance = hit.distance;
  return met;
}

// Radiance along a ray that starts outside the glass: the surface it meets on the screen, else one in
// the wider view around it, else the sky.
Met seen_along(IN(Ray) ray, Bool wanted, Bool mirrored) {
  Met first;
  first.color = sky_in_glass(u.sky, ray.direction, mirrored);
  first.surface = Bool(false);
  first.distance = Float(0.0f);
  Bool possible = wanted && cross_receivers(ray).meets;
  if (any_lane(possible)) {
    Met seen = met_in(scene_color, view_position, u.view, ray, possible);
    first.color = sel(seen.surface, seen.color, first.color);
    first.distance = sel(seen.surface, seen.distance, first.distance);
    first.surface = seen.surface;
    Bool rest = possible && !seen.surface;
    if (any_lane(rest)) {
      Met around = met_in(wide_color, wide_position, u.surroundings, ray, rest);
      first.color = sel(around.surface, around.color, first.color);
      first.distance = sel(around.surface, around.distance, first.distance);
      first.surface = first.surface || around.surface;
    }
  }
  return first;
}

// The colour of a view where a point lies, unless nothing is there, or the point is beside it.
Vec3 color_at(Texture colors, Texture positions, IN(View) view, Vec3 p, Vec3 otherwise) {
  Vec3 at = view_coordinates(view, p);
  Vec2 uv = view_uv(view, at);
  Bool there = view_w(view, at) > 0.0f && inside_unit(uv.x, uv.y) &&
               is_covered(fetch_nearest(positions, uv.x, uv.y));
  return sel(there, Vec3(fetch_nearest(colors, uv.x, uv.y)), otherwise);
}

// The mean over 16 rays spread by microfacets of this width: as long as the middle one, and where that has
// met nothing, to where they leave the box around all receivers. Each ray turns them by an angle of its own,
// after interleaved gradient noise (Jimenez 2014).
Vec3 spread_radiance(IN(Ray) ray, IN(Met) middle, Float width, Bool mirrored) {
  AxesAcross axes = axes_across(ray.direction);
  Float diagonal = frag_x() * 0.06711056f + frag_y() * 0.00583715f;
  Vec3 way = ray.direction;
  Float noise = (diagonal - floor(diagonal)) * 52.9829189f +
                (way.x * 571.0f + way.y * 3423.0f + way.z * 1650.0f);
  Vec3 sum = Vec3(0.0f);
  for (int i = 0; i < 16; i++) {
    Float turn = noise + float(i) * 0.618033989f;
    Vec2 slope = facet_slope(min_of(Float((float(i) + 0.5f) / 16.0f), 0.95f), turn) * width;
    Vec3 d = normalize_or(ray.direction + axes.x * slope.x + axes.y * slope.y, ray.direction);
    Crossing box = cross_receivers(ray_from(ray.start, d));
    Vec3 p = ray.start + d * sel(middle.surface, middle.distance, box.leaves);
    Vec3 sky = sky_in_glass(u.sky, d, mirrored);
    Vec3 color = color_at(wide_color, wide_position, u.surroundings, p, sky);
    color = color_at(scene_color, view_position, u.view, p, color);
    sum = sum + sel(box.meets, color, sky);
  }
  return sum / Float(16.0f);
}

// `width`: of the slopes by which directions are spread; 0: not at all.
Vec3 radiance_along(IN(Ray) ray, Float width, Bool wanted, Bool mirrored) {
  Met met = seen_along(ray, wanted, mirrored);
  Vec3 color = met.color;
  if (u.has_rough != 0) {
    Bool rough = wanted && width > 0.0f;
    if (any_lane(rough)) color = sel(rough, spread_radiance(ray, met, width, mirrored), color);
  }
  return color;
}

Vec3 exit_normal_at(Vec3 p, Vec3 fallback) {
  Vec2 uv = view_uv(u.view, view_coordinates(u.view, p));
  Vec4 smooth_normal = fetch_bilinear(view_exit_normal, uv.x, uv.y);
  Vec4 nearest = fetch_nearest(view_exit_normal, uv.x, uv.y);
  // Over a crease there is no normal between those of its two sides.
  Bool one_side = is_fully_covered(smooth_normal) && dot3(Vec3(smooth_normal), Vec3(nearest)) > 0.9f;
  return normalize_or(sel(one_side, Vec3(smooth_normal), Vec3(nearest)), fallback);
}

// The way through the glass and out of it.
struct Exit {
  Ray ray;
  Float inside_length;  // metres
  Bool mirrored;        // inside
};

// `inside`: the ray past the first surface; where the glass is not solid there is no second.
Exit leave_glass(IN(Ray) inside, Float ior, Bool solid) {
  Hit hit = intersect_secant(view_exit_position, u.view, search_along(u.view, inside, u.iterations, true));
  Exit exit;
  exit.inside_length = sel(solid, max_of(hit.distance, 0.0f), Float(0.0f));
  exit.ray.start = point_along(inside, exit.inside_length);
  Vec3 outward = exit_normal_at(exit.ray.start, -inside.direction);
  Vec3 normal = facing_normal(outward, inside.direction, Bool(true));
  Refraction bent = refraction_at(inside.direction, normal, ior);
  // What cannot leave is mirrored inside once and then followed straight on.
  exit.mirrored = solid && bent.total;
  Vec3 leaving = sel(exit.mirrored, reflected(inside.direction, normal, bent.cosine), bent.direction);
  exit.ray.direction = sel(solid, leaving, inside.direction);
  // What the glass stands on touches the place where the ray leaves: it is to lie before the ray, not behind.
  Float back = 2.0f * texel_extent_at(view_exit_position, u.view, exit.ray.start);
  exit.ray.start = exit.ray.start - exit.ray.direction * sel(solid, back, Float(0.0f));
  return exit;
}

// What a pixel shows of the casters.
struct Front {
  Bool from_inside;  // the camera looks at the surface from inside the material
  Vec3 point;
  Vec3 outward;      // the surface's normal
  Material material;
};

Front front_at(Vec4 position, Int column, Int row) {
  Vec4 normal = texel_fetch(view_caster_normal, column, row);
  Front front;
  front.from_inside = is_back_face(position);
  front.point = Vec3(position);
  front.outward = Vec3(normal);
  front.material = fetch_material(caster_materials, material_row(normal));
  if (u.has_caster_tint != 0) front.material.color = Vec3(texel_fetch(view_caster_tint, column, row));
  return front;
}

// Radiance that a caster's surface sends to the camera, where it is `seen`.
Vec3 radiance_of(IN(Front) front, Bool seen) {
  Material material = front.material;
  Vec3 sight = Vec3(u.forward);
  if (u.view.kind != VIEW_PARALLEL) sight = normalize_or(front.point - Vec3(u.eye), Vec3(u.forward));
  Vec3 normal = facing_normal(front.outward, sight, front.from_inside);
  Float eta = sel(front.from_inside, material.ior, 1.0f / material.ior);
  Refraction bent = refraction_at(sight, normal, eta);
  Bool solid = material.solid && !front.from_inside;
  Float width = sel(material.roughness > u.rough_from, material.roughness * material.roughness, Float(0.0f));
  Float ior = material.ior;
  Vec3 tint = material.color;
  if (u.has_rough != 0) {
    bent = either(material.thin, through_wall(sight, normal, normal, ior), bent);
    ior = sel(material.thin, Float(1.0f), ior);
    tint = wall_tint(material, tint, front.from_inside);
  }
  bent.reflectance = sel(bent.total, Float(1.0f), bent.reflectance * material.fresnel);
  Exit exit = leave_glass(ray_from(front.point, bent.direction), ior, solid);

  // A facet that leans by a slope turns what it mirrors by twice that, what passes by (n - 1) times, 1 / n of
  // it where light stays inside, at a wall by twice; two surfaces add their squares.
  Float turn = sel(solid, Float(1.41421356f), 1.0f / material.ior) * abs(material.ior - 1.0f);
  if (u.has_rough != 0) {
    turn = sel(material.thin, sel(solid, Float(2.82842712f), Float(2.0f)), turn);
  }
  Vec3 behind = radiance_along(exit.ray, turn * width, seen && !material.mirror, exit.mirrored) * tint *
                transmittance(material.absorption, exit.inside_length);
  Ray back = ray_from(front.point, reflected(sight, normal, bent.cosine));
  Vec3 mirrored = radiance_along(back, sel(material.mirror, Float(0.0f), 2.0f * width), seen, Bool(true));
  Vec3 metal = mirrored * metal_reflectance(material.color, bent.cosine);
  // What the second surface sends back is taken to leave as the rest does: nothing is lost to black.
  Vec3 glass = mirrored * bent.reflectance + behind * (1.0f - bent.reflectance);
  return sel(material.mirror, metal, glass);
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 caster = texel_fetch(view_caster_position, column, row);
  Vec4 surface = texel_fetch(view_position, column, row);
  Float z = view_coordinates(u.view, Vec3(caster)).z;
  Float surface_z = view_coordinates(u.view, Vec3(surface)).z;
  Bool seen = is_covered(caster) && (!is_covered(surface) || z < surface_z);
  Vec3 color = Vec3(texel_fetch(scene_color, column, row));
  if (any_lane(seen)) color = sel(seen, radiance_of(front_at(caster, column, row), seen), color);
  // What the frame lacks is one texel of zeros.
  color = color + Vec3(fetch_clamped(caster_highlight, column, row));
  if (u.blends != 0) color = behind_layers(color, column, row);
  beauty = Vec4(color, Float(1.0f));
}
#endif
