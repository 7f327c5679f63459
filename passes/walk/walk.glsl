// Light's whole way on one branch, from its first surface to its landing. walk.md explains.
#include "passes/shared/light_cone.glsl"
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/walk/walk_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, caster_position)
TEXTURE(1, caster_normal)
TEXTURE(2, caster_triangle)
TEXTURE(3, caster_materials)
TEXTURE(4, hierarchy_nodes)
TEXTURE(5, hierarchy_triangles)
TEXTURE(6, hierarchy_normals)
TEXTURE(7, reaching)
TEXTURE(8, receiver_position)
TEXTURE(9, second_surface)
TEXTURE(10, caster_texels)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, landing)
OUTPUT(1, Vec4, landing_flux)
OUTPUT(2, Vec4, landing_fresnel)
OUTPUT(3, Vec4, landing_absorbed)
OUTPUT(4, Vec4, landing_path)
OUTPUT(5, Vec4, landing_footprint)
OUTPUT(6, Vec4, second_hit)
#include "passes/shared/axes_across.glsl"
#include "passes/shared/caster_material.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/meeting.glsl"
#include "passes/shared/caster_triangles.glsl"
#include "passes/shared/wrapped.glsl"
#include "passes/shared/material.glsl"
#include "passes/shared/tangent_space.glsl"
#include "passes/shared/dressed_meeting.glsl"
#include "passes/shared/cone_falloff.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/absorption.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/refraction.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/shown_point.glsl"
#include "passes/shared/grid_light.glsl"
#include "passes/shared/light_path.glsl"
#include "passes/shared/media.glsl"
#include "passes/shared/interface.glsl"
#include "passes/shared/surface.glsl"
#include "passes/shared/microfacets.glsl"
#include "passes/shared/rough_surface.glsl"
#include "passes/shared/hierarchy.glsl"
#include "passes/shared/hit_texel.glsl"
#include "passes/shared/hit_there.glsl"
#include "passes/shared/way_draw.glsl"
#include "passes/shared/wide_light.glsl"
#include "passes/shared/enter_light.glsl"
#include "passes/shared/bend_light.glsl"
#include "passes/shared/land_light.glsl"

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

// Books what stays at a surface. Before a branch parts from another, that other one does.
void book(IN(BentLight) bent, Bool goes, INOUT(LandedLight) landed) {
  Vec3 share = Vec3(u.channel_share);
  landed.fresnel = sel(goes, bent.booked * share + landed.fresnel, landed.fresnel);
  landed.absorbed = sel(goes, bent.absorbed * share + landed.absorbed, landed.absorbed);
}

// What panes before the caster have taken of all channels but the brightest. One branch books it.
Vec3 taken_before(IN(LightPath) path) {
  Vec3 taken = (Vec3(path.whole) - path.flux) * Vec3(u.channel_share);
  return sel(Bool(u.mirrored_at == 0 && u.draws == 0), taken, Vec3(0.0f));
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

void write(IN(LandedLight) landed, Float entered) {
  landing = landed.at;
  landing_flux = Vec4(landed.flux, Float(0.0f));
  landing_fresnel = Vec4(landed.fresnel, sel(Bool(u.mirrored_at == 0 && u.draws == 0), entered, Float(0.0f)));
  landing_absorbed = Vec4(landed.absorbed, Float(0.0f));
  landing_path = Vec4(landed.path, Float(1.0f), Float(0.0f), Float(0.0f));
  landing_footprint = landed.footprint;
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Float facet = first_facet_draw(Float(column), Float(row));
  Arrival here = arrival_at(column, row, sel(Bool(u.light_shape != 0), facet, Float(0.0f)));
  if (u.light_shape != 0) facet = next_facet_draw(next_facet_draw(facet));
  Float entered = here.path.whole;
  Bool under_way = here.covered;
  Bool ended = Bool(false);
  LandedLight landed = nothing_landed();
  if (u.is_tinted != 0) landed.absorbed = taken_before(here.path);
  second_hit = Vec4(0.0f);
  Float draw = Float(0.0f);
  for (int surface = 1; surface <= u.bounces && any_lane(under_way); surface++) {
    Material material = fetch_material(caster_materials, here.material);
    draw = draw_at(surface, draw, column, row);
    if (u.has_textures != 0)
      put_on_textures(here.at, material, here.triangle, under_way, Bool(surface == 1));
    BentLight bent = bend_light(here.path, here.at, here.triangle, material, turn_at(surface, draw, facet));
    if (u.has_rough != 0) facet = next_facet_draw(next_facet_draw(facet));
    here.path = bent.path;
    TRACE(body, here.path.media.x);
    Bool goes = under_way && bent.goes;
    if (surface >= u.mirrored_at) book(bent, goes, landed);
    Bool has_hit = Bool(surface == 1 && u.reads_hit != 0) && !bent.drawn_back;
    Bool searches = goes && !bent.ends && !has_hit;
    Vec4 hit = Vec4(0.0f);
    if (any_lane(searches)) hit = hit_there(here.path.ray, here.path.own, here.path.media, searches);
    if (any_lane(has_hit)) hit = sel(has_hit, texel_fetch(second_surface, column, row), hit);
    if (surface == 1) second_hit = sel(goes, hit, Vec4(0.0f));
    under_way = goes && is_on_caster(hit) && surface < u.bounces;
    Bool ends = goes && !under_way && here.path.parted && surface >= u.mirrored_at;
    if (any_lane(ends)) land_light(here.path, hit, bent.ends, ends, landed);
    ended = ended || ends;
    if (any_lane(under_way)) go_on(here, hit, under_way);
  }
  write(landed, entered);
  discard_if(!ended);
}
#endif
