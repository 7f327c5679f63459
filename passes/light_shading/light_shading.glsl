// What one light gives to the surfaces that the camera sees: direct irradiance after shadows, irradiance
// from its caustics, and its mirror image.
#include "passes/shared/light_cone.glsl"
#include "passes/shared/light.glsl"
#include "passes/shared/homogeneous_medium.glsl"
UNIFORMS_BEGIN
#include "passes/light_shading/light_shading_uniforms.glsl"
#ifdef HAZE
Medium medium;
#endif
UNIFORMS_END
TEXTURE(0, view_position)
TEXTURE(1, view_normal)
TEXTURE(2, shadow_depth)
TEXTURE(3, caster_position)
TEXTURE(4, receiver_position)
TEXTURE(5, caustic_map)
TEXTURE(6, cascade_map)
TEXTURE(7, pane_transmittance)
TEXTURE(8, far_receiver_position)
TEXTURE(9, far_caustic_map)
TEXTURE(10, view_specular)
TEXTURE(11, view_caster_position)
TEXTURE(12, view_caster_normal)
TEXTURE(13, caster_materials)
TEXTURE(14, view_lift)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, direct)
OUTPUT(1, Vec4, caustic)
OUTPUT(2, Vec4, highlight)
OUTPUT(3, Vec4, caster_highlight)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/cone_falloff.glsl"
#include "passes/shared/light_falloff.glsl"
#include "passes/shared/incidence.glsl"
#include "passes/shared/caster_material.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/directional_albedo.glsl"
#include "passes/shared/highlight.glsl"
#include "passes/shared/casters_column.glsl"
#include "passes/shared/surface_plane.glsl"
#ifdef HAZE
#include "passes/shared/ray.glsl"
#include "passes/shared/medium_optics.glsl"
#include "passes/shared/light_way.glsl"
#endif

SurfacePoint surface_at(Int column, Int row) {
  Vec4 position = texel_fetch(view_position, column, row);
  SurfacePoint s;
  s.column = column;
  s.row = row;
  s.visible = is_covered(position);
  s.position = Vec3(position);
  s.normal = Vec3(texel_fetch(view_normal, column, row));
  return s;
}

#include "passes/light_shading/tangent_plane.glsl"
#include "passes/light_shading/shadows.glsl"
#include "passes/light_shading/caustic_lookup.glsl"
#include "passes/light_shading/pixel_footprint.glsl"

// What casters keep from a surface and give to it.
struct CasterLight {
  Float shadowed;  // the share of the direct light that they take
  Vec3 caustic;    // irradiance, relative to the light's intensity
};

CasterLight nothing_of_casters() {
  CasterLight none;
  none.shadowed = Float(0.0f);
  none.caustic = Vec3(0.0f);
  return none;
}

// The mean over what a pixel sees: at the point alone where that is hardly wider than a texel. The casters'
// shadow is averaged with their light, so that glass that bends nothing leaves no trace. `map`: the plane in
// the caustic map's axes, which are the light's but where it looks another way to see its caustic.
CasterLight mean_over(IN(Footprint) f, IN(TangentPlane) p, IN(TangentPlane) map, IN(Incidence) light,
                      IN(Reception) takes) {
  CasterLight sum = nothing_of_casters();
  for (int j = 0; any_lane(float(j) < f.rows); j++) {
    Float along = (float(j) + 0.5f) / f.rows - 0.5f;
    for (int i = 0; any_lane(float(j) < f.rows && float(i) < f.columns); i++) {
      Bool counts = float(j) < f.rows && float(i) < f.columns;
      Vec3 at = map.at + f.across * ((float(i) + 0.5f) / f.columns - 0.5f) + f.upward * along;
      Vec3 irradiance = caustic_at(at, map.q, light, takes);
      Vec3 behind = at;
      if (u.looks_aside != 0) behind = p.at;
      sum.shadowed = sum.shadowed + sel(counts, caster_share(p, behind), Float(0.0f));
      sum.caustic = sum.caustic + sel(counts, irradiance, Vec3(0.0f));
    }
  }
  Float samples = f.columns * f.rows;
  sum.shadowed = sum.shadowed / samples;
  sum.caustic = sum.caustic / samples;
  return sum;
}

// Points that take a caustic's light, where the map reaches, get it; elsewhere the casters only keep light.
// How much does not depend on what takes it: direct light is the same where no caustic is asked for.
CasterLight light_of_casters(IN(SurfacePoint) surface, IN(TangentPlane) p, IN(TangentPlane) map,
                             IN(Incidence) incidence) {
  CasterLight casters = nothing_of_casters();
  Incidence light = incidence;
  if (u.lights_backs != 0) light.facing = abs(dot3(surface.normal, light.travel));
  if (u.has_caustic != 0) {
    Reception takes = reception_of(surface, map);
    if (u.is_layer != 0) {
      Bool before = stands_before_caster(p);
      takes.near = takes.near && !before;
      takes.far = takes.far && !before;
    }
    if (u.lights_backs != 0) {
      // From behind only what the map shows takes light, not what stands before that.
      Bool behind = Bool(u.lights_backs > 1) && receives(receiver_position, map, true);
      takes.near = takes.near && (incidence.facing > 0.0f || behind);
    }
    Bool in_map = surface.visible;
    if (u.samples_across > 0) {
      Footprint f = footprint_at(surface, map.at, surface.visible);
      in_map = f.in_map;
      if (any_lane(in_map)) casters = mean_over(f, p, map, light, takes);
    } else {
      casters.shadowed = caster_share(p, p.at);
      casters.caustic = caustic_at(map.at, map.q, light, takes);
    }
    Bool takes_light = in_map && (takes.near || takes.far);
    casters.caustic = sel(takes_light, casters.caustic, Vec3(0.0f));
    if (any_lane(!in_map)) casters.shadowed = sel(in_map, casters.shadowed, caster_share(p, p.at));
  }
  return casters;
}

// The share of the direct light that opaque surfaces let through: to where the smooth surface is, which a
// coarse mesh stands for, not to its triangle (after Hanika, Hacking the Shadow Terminator, 2021). Where that
// faces away from the light, unlike the shading normal, it lies in shadow.
Float lit_share(IN(SurfacePoint) surface, IN(TangentPlane) triangle, Vec3 triangle_normal, Vec3 travel) {
  Float lit = Float(1.0f);
  if (u.has_shadow_map != 0) {
    TangentPlane p = triangle;
    Vec3 normal = triangle_normal;
    if (u.has_lift != 0) {
      Vec3 lift = Vec3(fetch_clamped(view_lift, surface.column, surface.row));
      normal = normalize_or(lift, triangle_normal);
      p = tangent_plane(u.shadow_view, surface.position + lift, normal);
    }
    Bool away = -dot3(normal, travel) * dot3(normal, surface.normal) <= 0.0f;
    lit = sel(away, Float(0.0f), 1.0f - shadow_share(p));
  }
  return lit;
}

#ifdef HAZE
// What the medium leaves of the light's colour on its way to a surface.
Vec3 through_medium(Vec3 position) {
  return transmittance(Vec3(u.medium.extinction), light_way(u.medium, u.light, position));
}
#endif

// What panes and blended surfaces leave of the light's colour on its way to a surface.
Vec3 tint_at(IN(SurfacePoint) surface, IN(TangentPlane) p) {
  Vec3 tint = Vec3(1.0f);
  if (u.has_panes != 0) tint = through_panes(p.at);
  // Blended surfaces do not shadow one another.
  if (u.has_panes != 0 && u.is_layer != 0)
    tint = sel(is_blended(texel_fetch(view_position, surface.column, surface.row)), Vec3(1.0f), tint);
  return tint;
}

// By the share of the light that opaque surfaces and casters leave.
Vec3 irradiance_by(IN(Incidence) light, Vec3 tint, Float lit) {
  Float irradiance = light.facing * light.falloff * lit / light.spread;
  Vec3 left = tint;
#ifdef HAZE
  left = left * through_medium(light.at);
#endif
  return Vec3(u.light.intensity) * left * irradiance;
}

// What arrives at a surface: past what keeps it, and by casters.
struct Arrival {
  Vec3 direct;
  Vec3 caustic;
};

Arrival arrival_at(IN(SurfacePoint) surface) {
  Incidence light = incidence_of(u.light, surface.position, surface.normal);
  Vec3 triangle_normal = plane_normal(view_position, surface);
  // Pixels side by side show surfaces one behind the other.
  if (u.is_layer > 1) triangle_normal = surface.normal;
  TangentPlane p = tangent_plane(u.shadow_view, surface.position, triangle_normal);
  TangentPlane map = p;
  if (u.looks_aside != 0) map = tangent_plane(u.caustic_view, surface.position, triangle_normal);
  CasterLight casters = light_of_casters(surface, p, map, light);
  Arrival arrival;
  arrival.caustic = Vec3(u.caustic_intensity) * casters.caustic;

  Float lit = lit_share(surface, p, triangle_normal, light.travel);
  if (u.has_caustic != 0) lit = lit * (1.0f - casters.shadowed);
  arrival.direct = irradiance_by(light, tint_at(surface, p), lit);
  return arrival;
}

#include "passes/light_shading/highlights.glsl"

void main() {
  TRACE(pixel, Vec2(frag_x(), frag_y()));
  SurfacePoint surface = surface_at(floor_to_int(frag_x()), floor_to_int(frag_y()));
  if (u.is_layer != 0) discard_if(!surface.visible);
  Vec3 arriving = Vec3(0.0f);
  Vec3 bent = Vec3(0.0f);
  Vec3 mirrored = Vec3(0.0f);
  if (u.casters_shine < 2 && any_lane(surface.visible)) {
    Arrival arrival = arrival_at(surface);
    arriving = sel(surface.visible, arrival.direct, arriving);
    bent = sel(surface.visible, arrival.caustic, bent);
    Vec3 all = arrival.direct + arrival.caustic;
    if (u.has_highlights != 0)
      mirrored = sel(surface.visible, receiver_highlight(surface, all), mirrored);
  }
  Vec3 of_casters = Vec3(0.0f);
  if (u.casters_shine == 1 || u.casters_shine == 2) of_casters = first_caster_highlight(surface);
  direct = Vec4(arriving, Float(0.0f));
  caustic = Vec4(bent, Float(0.0f));
  highlight = Vec4(mirrored, Float(0.0f));
  caster_highlight = Vec4(of_casters, Float(0.0f));
}
#endif
