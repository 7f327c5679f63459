// What glass and metal show that the picture does not: where the camera's rays end. hidden_ends.md explains.
#define SIGHT
#define ONE_WAY
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/hidden_ends/hidden_ends_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, picture_position)
TEXTURE(1, view_caster_position)
TEXTURE(2, view_caster_normal)
TEXTURE(3, caster_materials)
TEXTURE(4, hierarchy_nodes)
TEXTURE(5, hierarchy_triangles)
TEXTURE(6, hierarchy_normals)
TEXTURE(7, caster_texels)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, view_position)
OUTPUT(1, Vec4, view_normal)
OUTPUT(2, Vec4, view_albedo)
OUTPUT(3, Vec4, view_emission)
#include "passes/shared/bodies.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/shown_point.glsl"
#include "passes/shared/sight.glsl"

// How much of the receiver is shown: an added ground fades.
Float shown_at(IN(ReceiverMaterial) material, Vec3 p) {
  Float from = material.fade_from;
  Float over = material.fade_to - from;
  Bool fades = over > 0.0f;
  Float t = clamp_to((material.fade_to - length3(p - material.fade_centre)) / sel(fades, over, Float(1.0f)),
                     0.0f, 1.0f);
  return sel(fades, t * t * (3.0f - 2.0f * t), Float(1.0f));
}

void put_on_textures(INOUT(ReceiverMaterial) receiver, IN(CasterTriangle) triangle, IN(Meeting) at,
                     Bool wanted) {
  Dress dress = dress_at(at, triangle, wanted);
  Vec2 uv = dress.uv;
  receiver.albedo = receiver.albedo * sel(receiver.is_colored, Vec3(dress.tangent), Vec3(1.0f));
  receiver.albedo = receiver.albedo * Vec3(fetch_picture(picture_at(triangle.row, 4), uv, Bool(false)));
  receiver.emission = receiver.emission * Vec3(fetch_picture(picture_at(triangle.row, 13), uv, Bool(false)));
}

// What glass does not let through scatters by its colour.
void be_glass(INOUT(ReceiverMaterial) receiver, Int row, Bool wanted) {
  receiver.albedo = sel(wanted, fetch_material(caster_materials, row).color, receiver.albedo);
  receiver.emission = sel(wanted, Vec3(0.0f), receiver.emission);
  receiver.fade_to = sel(wanted, Float(0.0f), receiver.fade_to);
  receiver.is_colored = receiver.is_colored && !wanted;
  receiver.blended = receiver.blended || wanted;
}

// Writes the surface that stands there, as seen from the side that the ray comes from.
void write_end(IN(SightEnd) end) {
  Vec3 direction = end.sight.ray.direction;
  CasterTriangle triangle = fetch_triangle(sel(end.lands, end.hit.w - 1.0f, Float(0.0f)));
  Meeting at = meeting_at(triangle, end.hit, direction);
  ReceiverMaterial receiver = fetch_receiver(caster_materials, triangle.row);
  Bool in_glass = is_on_caster(end.hit);
  if (u.has_sheets != 0) be_glass(receiver, triangle.row, in_glass);
  if (u.has_textures != 0) put_on_textures(receiver, triangle, at, end.lands);
  view_position = Vec4(end.point, sel(receiver.blended, Float(2.0f), Float(1.0f)));
  view_normal = Vec4(sel(at.front, at.outward, -at.outward), Float(0.0f));
  view_albedo = Vec4(receiver.albedo, shown_at(receiver, end.point));
  view_emission = Vec4(receiver.emission, Float(1.0f));
}

SightEnd chosen_sheet(Bool condition, IN(SightEnd) end) {
  SightEnd chosen_end = end;
  chosen_end.hit = sel(condition, end.sheet.hit, end.hit);
  chosen_end.point = sel(condition, point_along(end.sheet.ray, end.sheet.hit.z), end.point);
  chosen_end.sight.ray = ray_from(sel(condition, end.sheet.ray.start, end.sight.ray.start),
                                  sel(condition, end.sheet.ray.direction, end.sight.ray.direction));
  chosen_end.lands = end.lands || condition;
  return chosen_end;
}

void main() {
  // A texel stands for two by two pixels, and looks where the first of them does.
  Int column = floor_to_int(frag_x()) * 2;
  Int row = floor_to_int(frag_y()) * 2;
  Vec4 caster = texel_fetch(view_caster_position, column, row);
  Bool seen = shows_front(caster, column, row);
  discard_if(!seen);
  Ways ways = ways_from(front_at(caster, column, row), seen);
  Sight sight = ways.behind;
  if (u.mirrors != 0) sight = ways.mirrored;
  // A texel shows one of the surfaces that are seen together, and each as often as it is seen: by the plastic
  // number, whose multiples lie evenly in both directions (Roberts 2018).
  Float drawn = fraction((Float(column) * 0.377438833f + Float(row) * 0.284920145f) + u.drawn_from);
  SightEnd end = end_of_sight(sight, drawn);
  Bool hidden = end.lands && !is_shown(end);
  if (u.has_sheets != 0) {
    Float of_sheets = sum_of(end.sheet.through);
    Float of_both = of_sheets + sum_of(end.sight.through);
    Bool sheet = of_sheets > 0.0f && (!hidden || drawn * of_both < of_sheets);
    if (any_lane(sheet)) end = chosen_sheet(sheet, end);
    hidden = hidden || sheet;
  }
  discard_if(!hidden);
  write_end(end);
}
#endif
