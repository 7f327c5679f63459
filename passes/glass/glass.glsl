// Glass, water and metal as the camera sees them, followed from surface to surface. glass.md explains.
#define SIGHT
#include "passes/shared/sky_model.glsl"
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/glass/glass_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, scene_color)
TEXTURE(1, picture_position)
TEXTURE(2, behind_color)
TEXTURE(3, mirrored_color)
TEXTURE(4, view_caster_position)
TEXTURE(5, view_caster_normal)
TEXTURE(6, caster_materials)
TEXTURE(7, hierarchy_nodes)
TEXTURE(8, hierarchy_triangles)
TEXTURE(9, hierarchy_normals)
TEXTURE(10, environment)
TEXTURE(11, caster_highlight)
TEXTURE(12, highlight_through_panes)
TEXTURE(13, layers)
TEXTURE(14, first_layer)
TEXTURE(15, caster_texels)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, beauty)
#include "passes/shared/bodies.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/layers_in_view.glsl"
#include "passes/shared/receivers_box.glsl"
#include "passes/shared/sky_radiance.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/shown_point.glsl"
Vec3 radiance_aside(Vec3 direction, Bool is_mirrored) { return sky_in_glass(u.sky, direction, is_mirrored); }
// Radiance that the first glass or metal behind panes mirrors of the lights. What the frame lacks is one
// texel of zeros.
Vec3 beyond_panes() {
  return Vec3(fetch_clamped(highlight_through_panes, floor_to_int(frag_x()), floor_to_int(frag_y())));
}
#include "passes/shared/sight.glsl"

// The radiance of what the picture does not show, which stands in every second row and column: the mean over
// the nearest four that have some, weighted as between them. w: how much of it is there, 0..1.
Vec4 hidden_color(Texture ends) {
  Float x = (frag_x() - 0.5f) * 0.5f;
  Float y = (frag_y() - 0.5f) * 0.5f;
  Int column = floor_to_int(x);
  Int row = floor_to_int(y);
  Vec3 sum = Vec3(0.0f);
  Float there = Float(0.0f);
  Float weights = Float(0.0f);
  for (int j = 0; j < 2; j++)
    for (int i = 0; i < 2; i++) {
      Vec4 end = fetch_clamped(ends, column + i, row + j);
      Float across = abs(x - Float(column + i));
      Float upward = abs(y - Float(row + j));
      Float weight = max_of((1.0f - across) * (1.0f - upward), 1.0e-4f);
      Float passes = end.w;
      Bool covered = passes < 1.0f;
      sum = sum + sel(covered, Vec3(end) * weight, Vec3(0.0f));
      there = there + sel(covered, (1.0f - passes) * weight, Float(0.0f));
      weights = weights + sel(covered, weight, Float(0.0f));
    }
  Float most = max_of(weights, 1.0e-4f);
  return Vec4(sum.x / most, sum.y / most, sum.z / most, there / most);
}

// The picture's colour where it shows a point, or so many pixels beside: between the four pixels around, of
// those that show its surface. w: their weight; 0: there are none.
Vec4 color_between(Vec3 p, Vec2 beside) {
  Vec3 q = view_coordinates(u.view, p);
  Vec2 uv = view_uv(u.view, q);
  Float width = Float(texture_width(picture_position));
  Float near_by = 8.0f * view_w(u.view, q) / (u.view.scale.x * width);
  Float x = uv.x * width - 0.5f + beside.x;
  Float y = uv.y * Float(texture_height(picture_position)) - 0.5f + beside.y;
  Int column = floor_to_int(x);
  Int row = floor_to_int(y);
  Vec3 sum = Vec3(0.0f);
  Float weights = Float(0.0f);
  for (int j = 0; j < 2; j++)
    for (int i = 0; i < 2; i++) {
      Vec4 position = fetch_clamped(picture_position, column + i, row + j);
      Float apart = abs(view_coordinates(u.view, Vec3(position)).z - q.z);
      Float weight = (1.0f - abs(x - Float(column + i))) * (1.0f - abs(y - Float(row + j)));
      weight = sel(is_covered(position) && apart <= near_by, max_of(weight, 1.0e-4f), Float(0.0f));
      sum = sum + Vec3(fetch_clamped(scene_color, column + i, row + j)) * weight;
      weights = weights + weight;
    }
  return Vec4(sum / max_of(weights, 1.0e-4f), weights);
}

// The mean over some places around.
Vec4 color_beside(Vec3 p) {
  Vec3 sum = Vec3(0.0f);
  Float weights = Float(0.0f);
  for (int k = 0; k < 8; k++) {
    Float x = Float((k & 1) == 0 ? 1.5f : -1.5f) * Float(k < 4 ? 1.0f : 2.0f);
    Float y = Float((k & 2) == 0 ? 1.5f : -1.5f) * Float(k < 4 ? 1.0f : 2.0f);
    Vec4 color = color_between(p, Vec2(x, y));
    Float weight = color.w;
    sum = sum + Vec3(color) * weight;
    weights = weights + weight;
  }
  return Vec4(sum / max_of(weights, 1.0e-4f), weights);
}

// The picture's colour where a point lies, unless nothing is there, it is nearer than a depth, or beside it.
Vec3 color_at(Vec3 p, Float nearest, Vec3 otherwise) {
  Vec3 at = view_coordinates(u.view, p);
  Vec2 uv = view_uv(u.view, at);
  Vec4 position = fetch_nearest(picture_position, uv.x, uv.y);
  Bool there = view_w(u.view, at) > 0.0f && inside_unit(uv.x, uv.y) && is_covered(position) &&
               view_coordinates(u.view, Vec3(position)).z >= nearest;
  Vec3 color = Vec3(fetch_nearest(scene_color, uv.x, uv.y));
  if (u.blends != 0) {
    Vec4 first = fetch_nearest(first_layer, uv.x, uv.y);
    Vec4 over = fetch_nearest(layers, uv.x, uv.y);
    color = sel(is_covered(first) && !is_before_glass(first), Vec3(over) + color * over.w, color);
  }
  return sel(there, color, otherwise);
}

Float nothing_nearer() { return Float(-1.0e30f); }

// Of a receiver that the picture does not show. Where no ray beside this one has found such, it is at the
// edge of what the picture shows. `asks`: whether hidden rays have gone the same way.
Vec3 color_of_hidden(Vec3 p, Texture ends, Bool asks, Vec3 sky) {
  Vec4 own = sel(asks, hidden_color(ends), Vec4(0.0f));
  Float there = own.w;
  Vec3 otherwise = sky;
  Bool at_edge = there == 0.0f;
  if (any_lane(at_edge)) {
    Vec4 shown = color_beside(p);
    Float weight = shown.w;
    otherwise = sel(at_edge && weight > 0.0f, Vec3(shown), sky);
  }
  return Vec3(own) + otherwise * (1.0f - there);
}

// Radiance of a receiver towards the camera, which stands for that towards the ray; of what the picture does
// not show, its own; where there is none, the sky's in the ray's direction.
Vec3 radiance_at(IN(SightEnd) end, Texture ends, Bool asks) {
  Vec3 color = sky_in_glass(u.sky, end.sight.ray.direction, end.sight.mirrored);
  Bool shown = is_shown(end);
  Bool hidden = end.lands && !shown;
  if (any_lane(hidden)) color = sel(hidden, color_of_hidden(end.point, ends, asks, color), color);
  if (any_lane(shown)) color = sel(shown, Vec3(color_between(end.point, Vec2(0.0f))), color);
  return color;
}

// The mean over 16 rays spread by microfacets: as long as the middle one, and where that has met nothing, to
// where they leave the box around all receivers. Each ray turns them by an angle of its own, after
// interleaved gradient noise (Jimenez 2014).
Vec3 spread_radiance(IN(SightEnd) end, Vec3 middle) {
  // Of what stands before the glass nothing is seen through it.
  Vec4 glass = texel_fetch(view_caster_position, floor_to_int(frag_x()), floor_to_int(frag_y()));
  Float glass_z = view_coordinates(u.view, Vec3(glass)).z;
  Float nearest = sel(end.sight.mirrored, nothing_nearer(), glass_z);
  Vec3 way = end.sight.ray.direction;
  AxesAcross axes = axes_across(way);
  Float diagonal = frag_x() * 0.06711056f + frag_y() * 0.00583715f;
  Float noise = (diagonal - floor(diagonal)) * 52.9829189f +
                (way.x * 571.0f + way.y * 3423.0f + way.z * 1650.0f);
  Float width = sqrt(end.sight.blur);
  Vec3 sum = Vec3(0.0f);
  for (int i = 0; i < 16; i++) {
    Float turned = noise + float(i) * 0.618033989f;
    Vec2 slope = facet_slope(min_of(Float((float(i) + 0.5f) / 16.0f), 0.95f), turned) * width;
    Vec3 d = normalize_or(way + axes.x * slope.x + axes.y * slope.y, way);
    Crossing box = cross_receivers(ray_from(end.sight.ray.start, d));
    Vec3 otherwise = sel(end.lands, middle, sky_in_glass(u.sky, d, end.sight.mirrored));
    Vec3 p = end.sight.ray.start + d * sel(end.lands, end.hit.z, box.leaves);
    sum = sum + sel(box.meets, color_at(p, nearest, otherwise), otherwise);
  }
  return sum / Float(16.0f);
}

// The mean colour of the picture's layers where it shows a point on one of them. w: 1; 0: it does not.
Vec4 color_of_layers(Vec3 p) {
  Vec2 uv = view_uv(u.view, view_coordinates(u.view, p));
  Vec4 over = fetch_bilinear(layers, uv.x, uv.y);
  Float covers = 1.0f - over.w;
  Bool before = is_before_glass(fetch_nearest(first_layer, uv.x, uv.y));
  Bool there = shows_point(first_layer, u.view, p) && !before && covers > 1.0e-3f;
  return sel(there, Vec4(Vec3(over) / sel(there, covers, Float(1.0f)), Float(1.0f)), Vec4(0.0f));
}

// The colour of what the ray has passed, as the picture shows it, or as hidden rays have found it. Where the
// picture does not show what lies behind, they have found both.
Vec3 color_of_sheets(IN(SightEnd) end, Vec3 behind, Texture ends) {
  Bool alike = end.lands && !is_shown(end);
  if (u.has_rough != 0) alike = alike || end.sight.blur > 0.0f;
  Vec4 hidden = hidden_color(ends);
  Float found = hidden.w;
  Vec3 color = sel(!alike && found > 0.0f, Vec3(hidden) / max_of(found, 1.0e-4f), behind);
  Vec4 seen = color_of_layers(point_along(end.sheet.ray, end.sheet.hit.z));
  Float is_seen = seen.w;
  Bool takes = !alike && is_seen > 0.0f;
  return sel(takes, Vec3(seen), color);
}

Vec3 seen_at(IN(SightEnd) end, Bool wanted, Texture ends, Bool asks) {
  Vec3 color = radiance_at(end, ends, asks);
  if (u.has_rough != 0) {
    Bool rough = wanted && end.sight.blur > 0.0f;
    if (any_lane(rough)) color = sel(rough, spread_radiance(end, color), color);
  }
  return color;
}

// By the way that has more than all others that are not taken, unless less than a tenth is left by it, summed
// over three channels; from twice that on it counts in full. So clear glass mirrors within only where it
// slants. Of what that way meets, weaker ways bring the sky.
Vec3 radiance_of_weaker(IN(Sight) weaker, Bool wanted, Texture ends) {
  Float counts = clamp_to(sum_of(weaker.through) * 10.0f - 1.0f, 0.0f, 1.0f);
  Bool follows = wanted && weaker.under_way && counts > 0.0f;
  Vec3 sum = weaker.through * radiance_aside(weaker.ray.direction, weaker.mirrored);
  if (any_lane(follows)) {
    Sight way = weaker;
    way.under_way = follows;
    SightEnd end = end_of_sight(way, Float(0.0f));
    Vec3 color = seen_at(end, follows, ends, Bool(false));
    Vec3 aside = end.weaker.through * radiance_aside(end.weaker.ray.direction, end.weaker.mirrored);
    Vec3 found = end.sight.aside + end.sight.through * color + (aside + end.sheet.through * color);
    sum = sel(follows, found * counts + sum * (1.0f - counts), sum);
  }
  return sum;
}

// `ends`: the radiance of what the picture does not show.
Vec3 radiance_along(IN(Sight) from, Texture ends) {
  SightEnd end = end_of_sight(from, Float(0.0f));
  Vec3 color = seen_at(end, from.under_way, ends, Bool(true));
  Vec3 sum = end.sight.aside + end.sight.through * color;
  if (any_lane(from.under_way)) sum = sum + radiance_of_weaker(end.weaker, from.under_way, ends);
  if (u.has_sheets != 0) {
    Bool any = sum_of(end.sheet.through) > 0.0f;
    if (any_lane(any)) sum = sum + end.sheet.through * color_of_sheets(end, color, ends);
  }
  return sum;
}

Vec3 radiance_of(IN(Front) front, Bool seen) {
  Ways ways = ways_from(front, seen);
  Vec3 behind = radiance_along(ways.behind, behind_color);
  return radiance_along(ways.mirrored, mirrored_color) + behind;
}

// A pixel's four places, in parts of it from its middle: within what one of several samples stands for.
Vec2 place_of(int k) {
  Float x = Float(k < 2 ? 0.0625f : 0.1875f);
  Float y = Float(k < 2 ? 0.1875f : -0.0625f);
  return Vec2(x, y) * Float((k & 1) == 0 ? 1.0f : -1.0f);
}

// The nearest weights that are not outside a triangle, nor on its edges.
Vec2 within_triangle(Vec2 weights) {
  Float x = max_of(weights.x, 1.0e-4f);
  Float y = max_of(weights.y, 1.0e-4f);
  Float most = max_of((x + y) / 0.9999f, Float(1.0f));
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

// What the body that the camera is in leaves of what comes from a surface.
Vec3 left_from(Vec4 position) {
  Float metres = length3(Vec3(position) - Vec3(u.eye));
  return sel(is_covered(position), left_by(Float(u.eye_media.x), metres), Vec3(1.0f));
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 caster = texel_fetch(view_caster_position, column, row);
  Vec4 picture = texel_fetch(picture_position, column, row);
  Bool seen = shows_front(caster, column, row);
  Vec3 color = Vec3(texel_fetch(scene_color, column, row));
  if (any_lane(seen)) {
    Front front = front_at(caster, column, row);
    // What the frame lacks is one texel of zeros.
    front.highlight = Vec3(fetch_clamped(caster_highlight, column, row));
    Vec3 shown = Vec3(0.0f);
    if (u.several_rays != 0) {
      shown = mean_radiance(front, seen);
    } else {
      shown = radiance_of(front, seen);
    }
    color = sel(seen, shown, color);
  }
  float body = u.eye_media.x;
  if (body > 0.0f) color = color * left_from(sel(seen, caster, picture));
  if (u.blends != 0) {
    Vec3 left = Vec3(1.0f);
    if (body > 0.0f) left = left_from(fetch_clamped(first_layer, column, row));
    color = behind_layers(color, left, seen, column, row);
  }
  beauty = Vec4(color, Float(1.0f));
}
#endif
