// Light's whole way on one branch, from its first surface to its landing. walk.md explains.
#include "passes/shared/light_cone.glsl"
#include "passes/shared/texture_transform.glsl"
#include "passes/shared/homogeneous_medium.glsl"
UNIFORMS_BEGIN
#include "passes/walk/walk_uniforms.glsl"
#ifdef HAZE
Medium medium;
#endif
#ifdef STRETCHES
int vertices_per_beam;
#endif
UNIFORMS_END
TEXTURE(0, caster_position)
TEXTURE(1, caster_normal)
TEXTURE(2, caster_materials)
TEXTURE(3, hierarchy_nodes)
TEXTURE(4, hierarchy_triangles)
TEXTURE(5, hierarchy_normals)
TEXTURE(6, reaching)
TEXTURE(7, receiver_position)
TEXTURE(8, second_surface)
TEXTURE(9, caster_texels)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
#ifdef STRETCHES
OUTPUT(0, Vec4, stretch_start)
OUTPUT(1, Vec4, stretch_way)
OUTPUT(2, Vec4, stretch_flux)
#else
OUTPUT(0, Vec4, landing)
OUTPUT(1, Vec4, landing_flux)
OUTPUT(2, Vec4, landing_fresnel)
OUTPUT(3, Vec4, landing_absorbed)
OUTPUT(4, Vec4, landing_path)
OUTPUT(5, Vec4, landing_footprint)
OUTPUT(6, Vec4, second_hit)
#ifdef HAZE
OUTPUT(7, Vec4, landing_medium)
#endif
#endif
#include "passes/shared/bodies.glsl"
#include "passes/shared/cone_falloff.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/shown_point.glsl"
#include "passes/shared/grid_light.glsl"
#include "passes/shared/light_path.glsl"
#include "passes/shared/hit_there.glsl"
#include "passes/shared/way_draw.glsl"
#include "passes/shared/wide_light.glsl"
#include "passes/shared/enter_light.glsl"
#include "passes/shared/bend_light.glsl"
#include "passes/shared/land_light.glsl"
#ifdef STRETCHES
#include "passes/stretches/drawn_stretch.glsl"
#else
#include "passes/walk/landed_light.glsl"
#endif

// The number that is drawn at a surface. Where both ways are followed 4 x 4 vertices draw together, and their
// rays stay near one another.
Float draw_at(int surface, Float before, Int column, Int row) {
  Float draw = next_draw(before);
  if (surface == 1) draw = first_draw(floor(Float(column) * 0.25f), floor(Float(row) * 0.25f));
  if (surface == u.splits + 1) draw = first_draw(Float(column), Float(row));
  return draw;
}

// The turn that the branch takes at the surface of this number.
Turn turn_at(int surface, Float draw, Float facet) {
  Turn turn;
  turn.both_ways = Bool(surface <= u.splits && (u.mirrored_at == 0 || surface <= u.mirrored_at));
  turn.mirrored = Bool(surface == u.mirrored_at);
  turn.drawn = drawn_share(draw);
  turn.chance = chance_to_part(surface - u.splits);
  turn.facet = Float(0.0f);
  turn.slope = Vec2(Float(0.0f), Float(0.0f));
  if (u.has_rough != 0) {
    turn.facet = facet;
    turn.slope = facet_slope(drawn_share(facet), drawn_share(next_facet_draw(facet)));
  }
  return turn;
}

// Finds the surface that light meets behind the one of this number.
Vec4 hit_behind(IN(BentLight) bent, Bool goes, int surface, Int column, Int row) {
  Bool has_hit = Bool(surface == 1 && u.reads_hit != 0) && !bent.drawn_back;
  Bool searches = goes && !bent.ends && !has_hit;
  Vec4 hit = Vec4(0.0f);
  if (any_lane(searches)) hit = hit_there(bent.path.ray, bent.path.own, bent.path.media, searches);
  if (any_lane(has_hit)) hit = sel(has_hit, texel_fetch(second_surface, column, row), hit);
  return hit;
}

// On to the caster's triangle that the ray meets.
void go_on(INOUT(Arrival) here, Vec4 hit, Bool on) {
  here.triangle = fetch_triangle(sel(on, hit.w - 1.0f, Float(0.0f)));
  here.at = meeting_at(here.triangle, hit, here.path.ray.direction);
  here.material = here.triangle.row;
  TRACE(stretch, here.at.stretch);
  TRACE(surface_point, here.at.point);
  TRACE(surface_normal, here.at.outward);
}

// Through the air to the caster; what panes before it have left of the light is in its flux already.
void come_to_caster(INOUT(Arrival) here, INOUT(Record) record) {
  Vec3 by_panes = Vec3(here.path.whole) - here.path.flux;
  Vec3 by_air = Vec3(0.0f);
#ifdef HAZE
  Float way = air_before(here.at.point, here.from);
  Vec3 left = medium_transmittance(u.medium, way);
  by_air = here.path.flux - here.path.flux * left;
  here.path.flux = here.path.flux * left;
  here.path.whole = here.path.whole * max_of(max_of(left.x, left.y), left.z);
#endif
  record_entry(record, by_panes, by_air);
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Float facet = first_facet_draw(Float(column), Float(row));
  Arrival here = arrival_at(column, row, sel(Bool(u.light_shape != 0), facet, Float(0.0f)));
  if (u.light_shape != 0) facet = next_facet_draw(next_facet_draw(facet));
  Float entered = here.path.whole;
  Bool under_way = here.covered;
  Record record = empty_record(column, row);
  come_to_caster(here, record);
  Float draw = Float(0.0f);
  for (int surface = 1; surface <= u.bounces && any_lane(under_way); surface++) {
    if (surface > 1 && surface > u.mirrored_at)
      record_stretch(record, here.path, here.at.stretch, under_way && here.path.parted);
    Material material = fetch_material(caster_materials, here.material);
    draw = draw_at(surface, draw, column, row);
    if (u.has_textures != 0)
      put_on_textures(here.at, material, here.triangle, under_way, Bool(surface == 1));
    BentLight bent = bend_light(here.path, here.at, here.triangle, material, turn_at(surface, draw, facet));
    if (u.has_rough != 0) facet = next_facet_draw(next_facet_draw(facet));
    here.path = bent.path;
    TRACE(body, here.path.media.x);
    Bool goes = under_way && bent.goes;
    if (surface >= u.mirrored_at) record_surface(record, bent, goes);
    Vec4 hit = hit_behind(bent, goes, surface, column, row);
    if (surface == 1) record_hit(sel(goes, hit, Vec4(0.0f)));
    under_way = goes && is_on_caster(hit) && surface < u.bounces;
    Bool ends = goes && !under_way && here.path.parted && surface >= u.mirrored_at;
    if (any_lane(ends)) record_end(record, here.path, hit, bent.ends, ends);
    if (any_lane(under_way)) go_on(here, hit, under_way);
  }
  write(record, entered);
  discard_if(is_discarded(record));
}
#endif
