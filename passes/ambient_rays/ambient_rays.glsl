// How much of the environment's light arrives at one in 4 x 4 of the picture's pixels; see ambient_rays.md.
UNIFORMS_BEGIN
#include "passes/ambient_rays/ambient_rays_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, view_position)
TEXTURE(1, view_normal)
TEXTURE(2, caster_materials)
TEXTURE(3, hierarchy_nodes)
TEXTURE(4, hierarchy_triangles)
TEXTURE(5, hierarchy_normals)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, ambient_rays)
#include "passes/shared/axes_across.glsl"
#include "passes/shared/caster_material.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/meeting.glsl"
#include "passes/shared/caster_triangles.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/surface_plane.glsl"
#include "passes/shared/hierarchy.glsl"

// What a surface at this distance keeps of what a near one would: farther ones send about as much light
// themselves (Zhukov, Iones, Kronin 1998).
Float nearness(Float distance) {
  Float part = distance / u.reach;
  return max_of(1.0f - part * part, 0.0f);
}

// What is left of a sight along a ray.
struct Sight {
  Ray ray;
  Float own;      // number of the triangle that it has come through, -1: none
  Float body;     // that it is in, 0: none
  Float metres;   // on its way so far
  Float open;     // the share of the light that comes against it
  Bool under_way;
};

// Light that comes from all around onto smooth glass: about 2.3 times as much is mirrored as at right angles,
// for an index of 1.5.
Float share_through(IN(Material) material) {
  Float part = (material.ior - 1.0f) / (material.ior + 1.0f);
  return max_of(1.0f - (part * part * 2.3f) * material.fresnel, 0.0f);
}

Float luminance(Vec3 c) { return c.x * 0.2126f + c.y * 0.7152f + c.z * 0.0722f; }

// Of a caster at the end of a stretch inside or outside of it. A pane is passed at once.
Float share_of_caster(IN(CasterTriangle) triangle, Bool leaves, Float stretch) {
  Material material = fetch_material(caster_materials, triangle.row);
  Float passing = luminance(material.color * material.transmitted);
  Float inside = exp_of(-(luminance(material.absorption) * stretch)) * passing;
  Float through = share_through(material) * sel(leaves, inside, Float(1.0f));
  Float wall = share_through(material) * share_through(material) * passing;
  through = sel(material.thin, wall, through);
  return sel(material.mirror, Float(0.0f), through);
}

// What lies below sends half as much light as the environment's ground: it is lit itself.
void go_on(INOUT(Sight) sight) {
  WalkingRay walking = walking_ray(sight.ray, sight.own, Vec4(sight.body, 0.0f, 0.0f, 0.0f));
  NearestTriangle met = nearest_triangle(walking, sight.under_way, u.reach - sight.metres);
  Bool ends = met.number < 0.0f || met.given_up;
  Bool at_caster = sight.under_way && !ends && met.number < float(u.first_receiver);
  Float share = Float(0.0f);
  if (any_lane(at_caster)) {
    CasterTriangle triangle = fetch_triangle(sel(at_caster, met.number, Float(0.0f)));
    Bool leaves = sight.body == triangle.body;
    share = sel(at_caster, share_of_caster(triangle, leaves, met.distance), share);
    Bool thin = fetch_material(caster_materials, triangle.row).thin;
    sight.body = sel(at_caster && !thin, sel(leaves, Float(0.0f), triangle.body), sight.body);
  }
  Float distance = sel(ends, Float(0.0f), met.distance);
  sight.metres = sight.metres + distance;
  Float dark = sel(sight.ray.direction.y < 0.0f, Float(0.5f), Float(1.0f));
  Float kept = nearness(sight.metres) * dark * (1.0f - share);
  sight.open = sel(sight.under_way && !ends, sight.open * (1.0f - kept), sight.open);
  sight.ray.start = point_along(sight.ray, distance);
  sight.own = met.number;
  sight.under_way = at_caster && share > 0.0f;
}

// Through four surfaces of glass at most; what lies behind them counts as open.
Float open_along(Vec3 start, Vec3 direction, Bool visible) {
  Sight sight;
  sight.ray = ray_from(start, direction);
  sight.own = Float(-1.0f);
  sight.body = Float(0.0f);
  sight.metres = Float(0.0f);
  sight.open = Float(1.0f);
  sight.under_way = visible;
  for (int surface = 0; surface < 4 && any_lane(sight.under_way); surface++) go_on(sight);
  return sight.open;
}

// Turns by the angle whose cosine and sine these are.
Vec2 turned(Vec2 v, Vec2 by) { return Vec2(v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x); }

// A number of four bits, of a texel in 4 x 4, so that neighbours differ much (Bayer 1973).
Int place_in_pattern(Int column, Int row) {
  Int x = column - (column / 4) * 4;
  Int y = row - (row / 4) * 4;
  Int x1 = x / 2;
  Int y1 = y / 2;
  Int x0 = x - x1 * 2;
  Int y0 = y - y1 * 2;
  return sel(x0 != y0, Int(8), Int(0)) + y0 * 4 + sel(x1 != y1, Int(2), Int(0)) + y1;
}

// Ray i of place p is number 16 i + p of 128 on a spiral by the golden angle, whose points have a share of
// the disc each: directions by the cosine (Malley), all of them over 4 x 4 texels.
Vec2 first_on_spiral(Int place) {
  Vec2 at = Vec2(1.0f, 0.0f);
  Int left = place;
  at = sel(left >= 8, turned(at, Vec2(0.939321296f, 0.343038631f)), at);
  left = sel(left >= 8, left - 8, left);
  at = sel(left >= 4, turned(at, Vec2(-0.984713485f, -0.17418195f)), at);
  left = sel(left >= 4, left - 4, left);
  at = sel(left >= 2, turned(at, Vec2(0.0874257247f, -0.996171041f)), at);
  left = sel(left >= 2, left - 2, left);
  return sel(left >= 1, turned(at, Vec2(-0.737368878f, 0.675490294f)), at);
}

Float open_share(IN(SurfacePoint) surface) {
  Vec3 plane = plane_normal(view_position, surface);
  Vec3 normal = sel(dot3(plane, surface.normal) < 0.0f, -plane, plane);
  Vec3 start = surface.position + normal * (u.touch * 4.0f + u.reach * 1.0e-5f);
  AxesAcross axes = axes_across(normal);
  Int place = place_in_pattern(floor_to_int(frag_x()), floor_to_int(frag_y()));
  Vec2 on_circle = first_on_spiral(place);
  Float sum = Float(0.0f);
  for (int i = 0; i < 8; i++) {
    Float squared = (Float(place) + (float(i) * 16.0f + 0.5f)) * 0.0078125f;
    Float radius = sqrt(squared);
    Vec3 aside = axes.x * (on_circle.x * radius) + axes.y * (on_circle.y * radius);
    sum = sum + open_along(start, aside + normal * sqrt(1.0f - squared), surface.visible);
    on_circle = turned(on_circle, Vec2(0.764648995f, 0.644446983f));
  }
  return sum * 0.125f;
}

void main() {
  Int column = floor_to_int(frag_x()) * 4 + 2;
  Int row = floor_to_int(frag_y()) * 4 + 2;
  Int last_column = Int(texture_width(view_position) - 1);
  Int last_row = Int(texture_height(view_position) - 1);
  SurfacePoint surface;
  surface.column = sel(column < last_column, column, last_column);
  surface.row = sel(row < last_row, row, last_row);
  Vec4 position = texel_fetch(view_position, surface.column, surface.row);
  surface.visible = is_covered(position);
  surface.position = Vec3(position);
  surface.normal = Vec3(texel_fetch(view_normal, surface.column, surface.row));
  ambient_rays = Vec4(0.0f);
  if (any_lane(surface.visible)) {
    Float open = open_share(surface);
    TRACE(open, open);
    ambient_rays = sel(surface.visible, Vec4(surface.position, 1.0f + open), Vec4(0.0f));
  }
}
#endif
