// Rays of light, to the next surface that each meets and to both of its ways from there. light_step.md
// explains.
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/light_step/light_step_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, rays)
TEXTURE(1, caster_materials)
TEXTURE(2, hierarchy_nodes)
TEXTURE(3, hierarchy_triangles)
TEXTURE(4, hierarchy_normals)
TEXTURE(5, caster_texels)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, met)
OUTPUT(1, Vec4, left)
OUTPUT(2, Vec4, mirrored_way)
OUTPUT(3, Vec4, mirrored_light)
OUTPUT(4, Vec4, crossing_way)
OUTPUT(5, Vec4, crossing_light)
OUTPUT(6, Vec4, crossing_media)
#include "passes/shared/bodies.glsl"
#include "passes/shared/hit_there.glsl"

// One of a ray's four texels, which stand in as many blocks of rows.
Vec4 ray_texel(Int column, Int row, int block) {
  return texel_fetch(rays, column, row + Int(texture_height(rays) / 4 * block));
}

// A way that light takes from a surface.
struct LightWay {
  Vec3 direction;
  Vec3 light;  // what is left of what goes that way
};

LightWay way_from(IN(Facet) facet, IN(Material) material, IN(Meeting) at, Vec3 from, Bool is_mirrored) {
  LightWay way;
  way.direction = direction_behind(facet.surface, from, is_mirrored);
  way.light = color_behind(facet.surface, material, is_mirrored);
  if (u.has_rough != 0) way.light = way.light * sent_by(facet, at, from, way.direction, is_mirrored);
  way.light = sel(strays(way.direction, at, from, is_mirrored), Vec3(0.0f), way.light);
  return way;
}

void write_ways(Vec3 from, IN(Meeting) at, IN(Facet) facet, IN(Material) material) {
  Surface surface = facet.surface;
  Interface both = surface.both;
  Float mirrored = sel(material.mirror || surface.total, Float(1.0f), surface.mirrored);
  LightWay back = way_from(facet, material, at, from, Bool(true));
  LightWay onward = way_from(facet, material, at, from, Bool(false));
  mirrored_way = Vec4(back.direction, sel(both.passes, Float(0.0f), mirrored));
  mirrored_light = Vec4(back.light, Float(0.0f));
  crossing_way = Vec4(onward.direction, sel(at.hole, Float(1.0f), Float(0.0f)));
  crossing_light = Vec4(sel(both.overflow, Vec3(0.0f), onward.light), Float(0.0f));
  crossing_media = both.media;
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 start = ray_texel(column, row, 0);
  Vec4 way = ray_texel(column, row, 1);
  Vec4 media = ray_texel(column, row, 2);
  Ray ray = ray_from(Vec3(start), Vec3(way));
  Float there = way.w;
  Vec4 hit = hit_there(ray, start.w - 1.0f, media, there > 0.0f);
  Bool caster = is_on_caster(hit);
  CasterTriangle triangle = fetch_triangle(sel(is_surface(hit), hit.w - 1.0f, Float(0.0f)));
  Meeting at = meeting_at(triangle, hit, ray.direction);
  Material material = fetch_material(caster_materials, triangle.row);
  if (u.has_textures != 0) put_on_textures(at, material, triangle, caster, Bool(false));
  Vec2 slope = Vec2(Float(0.0f), Float(0.0f));
  if (u.has_rough != 0) {
    Vec4 drawn = ray_texel(column, row, 3);
    slope = facet_slope(drawn.x, drawn.y);
  }
  Interface both = interface_at(media, at, triangle, material);
  Facet facet = facet_at(ray.direction, at, both, material, slope);
  met = Vec4(at.point, hit.w);
  left = Vec4(left_by(media.x, hit.z), sel(at.front, Float(1.0f), Float(0.0f)));
  write_ways(ray.direction, at, facet, material);
}
#endif
