// Glass, water and metal as the camera sees them, followed from surface to surface. walked_glass.md explains.
#include "passes/shared/sky_model.glsl"
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/walked_glass/walked_glass_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, scene_color)
TEXTURE(1, view_position)
TEXTURE(2, wide_color)
TEXTURE(3, wide_position)
TEXTURE(4, view_caster_position)
TEXTURE(5, view_caster_normal)
TEXTURE(6, view_caster_triangle)
TEXTURE(7, caster_materials)
TEXTURE(8, hierarchy_nodes)
TEXTURE(9, hierarchy_triangles)
TEXTURE(10, hierarchy_normals)
TEXTURE(11, environment)
TEXTURE(12, caster_highlight)
TEXTURE(13, layers)
TEXTURE(14, first_layer)
TEXTURE(15, caster_texels)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, beauty)
#include "passes/shared/axes_across.glsl"
#include "passes/shared/caster_material.glsl"
#include "passes/shared/caster_triangles.glsl"
#include "passes/shared/wrapped.glsl"
#include "passes/shared/material.glsl"
#include "passes/shared/tangent_space.glsl"
#include "passes/shared/dressed_meeting.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/absorption.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/layers_before_glass.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/refraction.glsl"
#include "passes/shared/sky_radiance.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/shown_point.glsl"
#include "passes/shared/hierarchy.glsl"
#include "passes/shared/media.glsl"
#include "passes/shared/interface.glsl"
#include "passes/shared/surface.glsl"
#include "passes/shared/hit_texel.glsl"

// A ray of sight on its way.
struct Sight {
  Ray ray;
  Float own;      // the triangle that it starts on
  Vec4 media;     // the bodies that it is in
  Vec3 through;   // what is left of the radiance from its end
  Bool mirrored;
  Bool under_way;
};

Vec3 shown_color(Texture colors, IN(View) view, Vec3 p) {
  Vec2 uv = view_uv(view, view_coordinates(view, p));
  return Vec3(fetch_bilinear(colors, uv.x, uv.y));
}

// What the picture shows in a direction where it shows no opaque surface: layers over the sky, which count as
// far away.
Vec3 shown_far_away(Vec3 direction, Vec3 otherwise) {
  Vec3 q = transform_vector(u.view.from_scene, direction);
  Vec2 uv = view_uv(u.view, q);
  Bool sky = !is_covered(fetch_nearest(view_position, uv.x, uv.y));
  Bool there = sky && q.z > 1.0e-3f && inside_unit(uv.x, uv.y);
  return sel(there, Vec3(fetch_nearest(scene_color, uv.x, uv.y)), otherwise);
}

// Radiance of a receiver at p towards the camera, which stands for that towards the ray; of what neither view
// shows, the sky's in the ray's direction.
Vec3 radiance_at(Vec3 p, Vec3 direction, Bool lands, Bool mirrored) {
  Vec3 color = sky_in_glass(u.sky, direction, mirrored);
  if (u.blends != 0) {
    if (u.view.kind != VIEW_PARALLEL) color = sel(mirrored, color, shown_far_away(direction, color));
  }
  Bool wide = lands && shows_point(wide_position, u.surroundings, p);
  color = sel(wide, shown_color(wide_color, u.surroundings, p), color);
  Bool seen = lands && shows_point(view_position, u.view, p);
  return sel(seen, shown_color(scene_color, u.view, p), color);
}

// The way that a ray takes at a surface: the stronger, which then stands for both; or `straight` on.
void turn(INOUT(Sight) sight, IN(Meeting) meeting, IN(CasterTriangle) triangle, Bool straight, Bool wanted) {
  Meeting at = meeting;
  Material material = fetch_material(caster_materials, triangle.row);
  if (u.has_textures != 0) put_on_textures(at, material, triangle, wanted, Bool(false));
  Interface both = interface_at(sight.media, at, triangle, material);
  both.passes = both.passes || straight;
  Vec3 before = sight.ray.direction;
  Surface surface = surface_at(before, at, both, material);
  Bool back = most_is_mirrored(surface, material, surface.mirrored > 0.5f);
  sight.ray = ray_from(at.point, direction_behind(surface, before, back));
  sight.own = at.number;
  sight.mirrored = sight.mirrored || back;
  sight.media = sel(back, sight.media, both.media);
  sight.through = sight.through * color_behind(surface, material, back);
  sight.under_way = sight.under_way && !strays(sight.ray.direction, at, before, back);
}

Sight chosen(Bool condition, IN(Sight) a, IN(Sight) b) {
  Sight sight;
  sight.ray = ray_from(sel(condition, a.ray.start, b.ray.start),
                       sel(condition, a.ray.direction, b.ray.direction));
  sight.own = sel(condition, a.own, b.own);
  sight.media = sel(condition, a.media, b.media);
  sight.through = sel(condition, a.through, b.through);
  sight.mirrored = sel(condition, a.mirrored, b.mirrored);
  sight.under_way = sel(condition, a.under_way, b.under_way);
  return sight;
}

// Radiance that a ray brings, by all the surfaces that it meets. At the last ones it is not bent any more, so
// that it ends on what stands there.
Vec3 radiance_along(IN(Sight) from) {
  Sight sight = from;
  Vec3 end = sight.ray.start;
  Bool lands = Bool(false);
  for (int k = 0; k < u.most_surfaces && any_lane(sight.under_way); k++) {
    Vec4 hit = hit_ahead(sight.ray, sight.own, sight.media, sight.under_way);
    Bool caster = sight.under_way && is_on_caster(hit);
    Bool receiver = sight.under_way && is_surface(hit) && !caster;
    Vec3 taken = left_by(sight.media.x, hit.z);
    sight.through = sel(caster || receiver, sight.through * taken, sight.through);
    end = sel(receiver, point_along(sight.ray, hit.z), end);
    lands = lands || receiver;
    if (any_lane(caster)) {
      CasterTriangle triangle = fetch_triangle(sel(caster, hit.w - 1.0f, Float(0.0f)));
      Meeting at = meeting_at(triangle, hit, sight.ray.direction);
      Sight next = sight;
      turn(next, at, triangle, Bool(k >= u.surfaces), caster);
      sight = chosen(caster, next, sight);
    }
    sight.under_way = sight.under_way && caster;
  }
  return sight.through * radiance_at(end, sight.ray.direction, lands, sight.mirrored);
}

// What a pixel shows of the casters.
struct Front {
  Meeting at;
  CasterTriangle triangle;
  Material material;
};

Front front_at(Vec4 position, Int column, Int row) {
  Vec4 normal = texel_fetch(view_caster_normal, column, row);
  Float number = texel_fetch(view_caster_triangle, column, row).x - 1.0f;
  Front front;
  front.triangle = fetch_triangle(max_of(number, 0.0f));
  front.material = fetch_material(caster_materials, material_row(normal));
  front.at.point = Vec3(position);
  front.at.outward = Vec3(normal);
  front.at.plane = normalize_or(cross3(front.triangle.edge1, front.triangle.edge2), front.at.outward);
  front.at.front = !is_back_face(position);
  front.at.number = number;
  front.at.stretch = Float(0.0f);
  front.at.hole = Bool(false);
  return front;
}

Vec3 sight_to(Vec3 p) {
  Vec3 sight = Vec3(u.forward);
  if (u.view.kind != VIEW_PARALLEL) sight = normalize_or(p - Vec3(u.eye), Vec3(u.forward));
  return sight;
}

// At the first surface both ways are followed, what it mirrors and what it lets through.
Vec3 radiance_of(IN(Front) drawn, Bool seen) {
  Front front = drawn;
  if (u.has_textures != 0)
    put_on_textures(front.at, front.material, front.triangle, seen, Bool(true));
  Vec3 sight = sight_to(front.at.point);
  Interface both = interface_at(Vec4(0.0f), front.at, front.triangle, front.material);
  Surface surface = surface_at(sight, front.at, both, front.material);
  Sight back;
  back.ray = ray_from(front.at.point, direction_behind(surface, sight, Bool(true)));
  back.own = front.at.number;
  back.media = Vec4(0.0f);
  back.mirrored = Bool(true);
  Vec3 color = color_behind(surface, front.material, Bool(true));
  back.through = sel(front.material.mirror, color, Vec3(surface.mirrored));
  back.under_way = seen;
  Sight on = back;
  on.ray = ray_from(front.at.point, surface.bent.direction);
  on.media = both.media;
  on.mirrored = Bool(false);
  on.through = front.material.color * (1.0f - surface.mirrored);
  on.under_way = seen && !surface.one_way;
  Vec3 behind = radiance_along(on);
  Vec3 before = radiance_along(back);
  return before + sel(surface.one_way, Vec3(0.0f), behind);
}

// A pixel's four places, in parts of it from its middle: within what one of several samples stands for.
Vec2 place_of(int k) {
  Float x = Float(k < 2 ? 0.0625f : 0.1875f);
  Float y = Float(k < 2 ? 0.1875f : -0.0625f);
  return Vec2(x, y) * Float((k & 1) == 0 ? 1.0f : -1.0f);
}

// The nearest weights that are not outside a triangle, nor on its edges.
Vec2 within_triangle(Vec2 weights) {
  Float x = max_of(weights.x, 0.01f);
  Float y = max_of(weights.y, 0.01f);
  Float most = max_of((x + y) / 0.99f, Float(1.0f));
  return Vec2(x / most, y / most);
}

// What the pixel shows there, or as near to there as its triangle goes.
Front beside(IN(Front) front, Vec2 place) {
  mat4 axes = u.view.from_scene;
  Vec3 p = front.at.point;
  Float w = view_w(u.view, view_coordinates(u.view, p));
  Float x = place.x * w / (u.view.scale.x * float(texture_width(view_caster_position)));
  Float y = place.y * w / (u.view.scale.y * float(texture_height(view_caster_position)));
  Vec3 moved =
      Vec3(axes[0].x * x + axes[0].y * y, axes[1].x * x + axes[1].y * y, axes[2].x * x + axes[2].y * y);
  Vec3 sight = sight_to(p + moved);
  Float closing = dot3(sight, front.at.plane);
  Bool steep = abs(closing) > 0.05f;
  Float along = dot3(moved, front.at.plane) / sel(steep, closing, Float(1.0f));
  Vec2 here = weights_at(front.triangle, p - front.triangle.corner);
  Vec2 there = within_triangle(here + weights_at(front.triangle, moved - sight * along));
  Vec2 by = sel(steep, there - here, Vec2(0.0f));
  Front other = front;
  other.at.point = p + (front.triangle.edge1 * by.x + front.triangle.edge2 * by.y);
  Vec3 turned = front.triangle.turn1 * by.x + front.triangle.turn2 * by.y;
  other.at.outward = normalize_or(front.at.outward + turned, front.at.outward);
  return other;
}

Bool differ(Vec3 a, Vec3 b) {
  Float apart = max_of(max_of(abs(a.x - b.x), abs(a.y - b.y)), abs(a.z - b.z));
  Float most = max_of(max_of(max_of(a.x, b.x), max_of(a.y, b.y)), max_of(a.z, b.z));
  return apart > 0.1f * most;
}

// The mean of what two rays bring or, where these differ, four: behind bumps a pixel's rays go everywhere.
Vec3 mean_radiance(IN(Front) front, Bool seen) {
  Vec3 sum = Vec3(0.0f);
  Vec3 first = Vec3(0.0f);
  Float count = Float(0.0f);
  Bool wanted = seen;
  for (int k = 0; k < 4 && any_lane(wanted); k++) {
    Vec3 one = radiance_of(beside(front, place_of(k)), wanted);
    sum = sel(wanted, sum + one, sum);
    count = sel(wanted, count + 1.0f, count);
    if (k == 0) first = one;
    if (k == 1) wanted = wanted && differ(first, one);
  }
  return sum / max_of(count, 1.0f);
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
  if (any_lane(seen)) {
    Front front = front_at(caster, column, row);
    Vec3 shown = Vec3(0.0f);
    if (u.several_rays != 0) {
      shown = mean_radiance(front, seen);
    } else {
      shown = radiance_of(front, seen);
    }
    color = sel(seen, shown, color);
  }
  // What the frame lacks is one texel of zeros.
  color = color + Vec3(fetch_clamped(caster_highlight, column, row));
  if (u.blends != 0) color = behind_layers(color, column, row);
  beauty = Vec4(color, Float(1.0f));
}
#endif
