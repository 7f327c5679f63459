// Light behind a surface as attachments. A branch's turn at the surface is in the uniforms mirrored and
// splits: of surface 1.
OUTPUT(0, Vec4, path_start)      // w: number of the triangle there plus 1, 0: goes nowhere, -1: has ended
OUTPUT(1, Vec4, path_direction)  // w: what it has met
OUTPUT(2, Vec4, path_flux)       // w: the light's on the cell
OUTPUT(3, Vec4, path_media)
OUTPUT(4, Vec4, path_width)      // xy: along the grid's rows, zw: along its columns, in axes across the way
OUTPUT(5, Vec4, path_spread)
OUTPUT(6, Vec4, booked)
OUTPUT(7, Vec4, absorbed)
#include "passes/shared/axes_across.glsl"
#include "passes/shared/caster_material.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/meeting.glsl"
#include "passes/shared/caster_triangles.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/absorption.glsl"
#include "passes/shared/refraction.glsl"
#include "passes/shared/light_path.glsl"
#include "passes/shared/media.glsl"
#include "passes/shared/interface.glsl"
#include "passes/shared/surface.glsl"
#include "passes/shared/microfacets.glsl"
#include "passes/shared/smooth_surface.glsl"
#include "passes/shared/rough_surface.glsl"
#include "passes/shared/bend_light.glsl"

Turn turn_now() {
  Turn turn;
  turn.both_ways = Bool(u.splits != 0);
  turn.mirrored = Bool(u.mirrored_at != 0);
  turn.drawn = Float(0.5f);
  turn.chance = Float(0.25f);
  turn.facet = Float(0.0f);
  turn.slope = Vec2(Float(0.0f), Float(0.0f));
  return turn;
}

Vec4 in_axes(IN(AxesAcross) axes, Vec3 x, Vec3 y) {
  return Vec4(dot3(x, axes.x), dot3(x, axes.y), dot3(y, axes.x), dot3(y, axes.y));
}

void write_bent(IN(BentLight) bent, Bool covered) {
  LightPath path = bent.path;
  AxesAcross axes = axes_across(path.ray.direction);
  Float mark = path.own + 1.0f;
  path_start = Vec4(path.ray.start, sel(bent.ends, Float(-1.0f), mark));
  path_direction = Vec4(path.ray.direction, path.path);
  path_flux = Vec4(path.flux, path.whole);
  path_media = path.media;
  path_width = in_axes(axes, path.width_x, path.width_y);
  path_spread = in_axes(axes, path.spread_x, path.spread_y);
  booked = Vec4(bent.booked, Float(0.0f));
  absorbed = Vec4(bent.absorbed, Float(0.0f));
  discard_if(!(covered && bent.goes));
}
