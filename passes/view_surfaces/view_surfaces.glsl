// The first opaque surface that the camera sees: position, normal, colour, light of its own.
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#include "passes/view_surfaces/view_surfaces_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, base_color)
TEXTURE(1, normal_texture)
TEXTURE(2, emissive)
TEXTURE(3, metallic_roughness)
TEXTURE(4, occlusion)
TEXTURE(5, base_color_levels)
TEXTURE(6, normal_levels)
TEXTURE(7, emissive_levels)
TEXTURE(8, metallic_roughness_levels)
TEXTURE(9, occlusion_levels)
TEXTURE(10, behind)
TEXTURE(11, before)
TEXTURE(12, glass)
TEXTURE(13, transmission_texture)
#include "passes/shared/tangent_vertex.glsl"
VARYING_SMOOTH(10, Vec2, surface_uv)
VARYING_SMOOTH(12, Vec2, surface_uv_density)
VARYING_SMOOTH(14, Float, tangent_plane_height)  // of the vertex's, over the origin

#ifdef VERTEX_STAGE
ATTRIBUTE(12, Vec2, uv_density)

void main() {
  place_surface();
  surface_uv = uv;
  surface_uv_density = uv_density;
  tangent_plane_height = dot3(position, normal);
}
#else
OUTPUT(0, Vec4, view_position)
OUTPUT(1, Vec4, view_normal)
OUTPUT(2, Vec4, view_albedo)
OUTPUT(3, Vec4, view_specular)
OUTPUT(4, Vec4, view_emission)
OUTPUT(5, Vec4, view_lift)
OUTPUT(6, Float, view_ambient)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/wrapped.glsl"
#include "passes/shared/material.glsl"
#include "passes/shared/transformed_uv.glsl"
#include "passes/shared/mip_levels.glsl"
#include "passes/shared/tangent_space.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/directional_albedo.glsl"
#include "passes/shared/pane_layer.glsl"

// How large a part of the texture coordinates a pixel sees. At a depth z it is z times as wide as in the
// view's window; on a surface that leans away longer, by z / |n.q| for a place q in view coordinates, up to
// 256 times.
SeenUv seen_here(Vec3 n) {
  SeenUv seen;
  seen.at = surface_uv;
  seen.reach = Vec2(Float(0.0f), Float(0.0f));
  if (u.pixel_side > 0.0f) {
    Vec3 ray = Vec3(0.0f, 0.0f, 1.0f);
    if (u.view.kind != VIEW_PARALLEL) ray = view_coordinates(u.view, surface_position);
    Float facing = abs(dot3(transform_vector(u.view.from_scene, n), ray));
    Float longer = clamp_to(ray.z / max_of(facing, ray.z * 0.00390625f), 1.0f, 256.0f);
    seen.reach = surface_uv_density * (u.pixel_side * ray.z * longer);
  }
  return seen;
}

Vec3 textured_normal(Vec3 n, IN(SeenUv) seen) {
  Vec4 texel = fetch_seen(normal_texture, normal_levels, u.normal_use, seen);
  return leaned_normal(n, surface_tangent, tangent_space_normal(texel, Float(u.normal_scale)));
}

// How rough the surface is, and how much of it is metal.
struct Finish {
  Float roughness;
  Float metallic;
};

Finish finish_here(IN(SeenUv) seen) {
  Finish f;
  f.roughness = Float(u.roughness);
  f.metallic = Float(u.metallic);
  if (u.metallic_roughness_use.levels > 0) {
    Vec4 texel = fetch_seen(metallic_roughness, metallic_roughness_levels, u.metallic_roughness_use, seen);
    f.roughness = f.roughness * texel.y;
    f.metallic = f.metallic * texel.z;
  }
  return f;
}

Float ambient_share(IN(SeenUv) seen) {
  Float share = Float(1.0f);
  if (u.occlusion_use.levels > 0) {
    Vec4 texel = fetch_seen(occlusion, occlusion_levels, u.occlusion_use, seen);
    share = 1.0f - u.occlusion_strength * (1.0f - texel.x);
  }
  return share;
}

// How much of the surface is shown: smoothly from 1 to 0, by the distance from the fade's middle.
Float shown_here() {
  Float shown = Float(1.0f);
  if (u.fade_to > u.fade_from) {
    Float away = length3(surface_position - Vec3(u.fade_centre));
    Float t = clamp_to((u.fade_to - away) / (u.fade_to - u.fade_from), 0.0f, 1.0f);
    shown = t * t * (3.0f - 2.0f * t);
  }
  return shown;
}

// Along the surface's normal n, out to the mean of the vertices' tangent planes. Zero where they do not lie
// on the side that is seen: of a flat surface, of a hollow one.
Vec3 lift_along(Vec3 n, Bool from_behind) {
  Float height = tangent_plane_height - dot3(surface_position, surface_normal);
  Float towards_viewer = sel(from_behind, -height, height);
  Float rounding = 1.0e-5f * (abs(surface_position.x) + abs(surface_position.y) + abs(surface_position.z));
  return n * sel(towards_viewer > rounding, height, Float(0.0f));
}

// Does this fragment lie before the glass or metal in its pixel, or on it?
Bool before_glass(Float z) {
  // What the frame lacks is one texel of zeros.
  Vec4 caster = fetch_clamped(glass, floor_to_int(frag_x()), floor_to_int(frag_y()));
  return is_covered(caster) && z <= view_coordinates(u.view, Vec3(caster)).z;
}

// Is a blended surface not the next behind the layer before, or behind what is opaque? Where that layer lies
// before glass, what lies behind the glass is left out.
Bool not_in_layer(Float z) {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 surface = fetch_clamped(behind, column, row);
  Bool left_out = is_covered(surface) && z >= surface.w;
  if (u.layer > 1) {
    Vec4 nearer = fetch_clamped(before, column, row);
    Bool beyond_glass = before_glass(nearer.w) && !before_glass(z);
    left_out = left_out || !is_covered(nearer) || z <= nearer.w || beyond_glass;
  }
  return left_out;
}

Vec4 base_factor_here() {
  Vec4 base = Vec4(u.base_factor);
  if (u.has_colors != 0) base = base * surface_tangent;
  return base;
}

// What decides where the surface is at all: not averaged, for of leaves smaller than a pixel that would leave
// nothing.
Float finest_opacity() {
  Float opacity = base_factor_here().w;
  if (u.alpha_cutoff > 0.0f && u.base_color_use.levels > 0) {
    Vec2 place = wrapped(u.base_color_use.uv, transformed_uv(u.base_color_use.uv, surface_uv));
    opacity = opacity * fetch_finest(base_color, u.base_color_use, place).w;
  }
  return opacity;
}

// The cosine between the camera's ray and the normal.
Float facing_here(Vec3 n) {
  Vec3 ray = Vec3(0.0f, 0.0f, 1.0f);
  if (u.view.kind != VIEW_PARALLEL)
    ray = normalize_or(view_coordinates(u.view, surface_position), ray);
  return min_of(abs(dot3(normalize_or(transform_vector(u.view.from_scene, n), ray), ray)), Float(1.0f));
}

// How a surface answers light: scattered, and mirrored at normal incidence; how much of it there is.
struct Answer {
  Vec3 albedo;
  Vec3 reflectance;
  Float shown;
};

// glTF's fresnel_mix: what the coat mirrors is not scattered.
Answer coated(Vec3 base, IN(Finish) finish, Vec3 shading) {
  Answer answer;
  answer.albedo = base * (1.0f - finish.metallic);
  answer.reflectance = base * finish.metallic + Vec3(u.dielectric) * (1.0f - finish.metallic);
  answer.shown = Float(1.0f);
  if (u.is_coated != 0) {
    DirectionalAlbedo mirrored = directional_albedo(facing_here(shading), finish.roughness);
    Vec3 facing = Vec3(u.dielectric);
    Float whitest = max_of(max_of(facing.x, facing.y), facing.z);
    answer.albedo = answer.albedo * max_of(1.0f - sent_back(mirrored, whitest), Float(0.0f));
  }
  return answer;
}

// What glass or a pane does not let through scatters, or mirrors as metal does, what its face leaves, or its
// two faces. What these mirror and let through `glass` has; and of what is not `in_sight`, what they leave.
Answer under_glass(Vec3 base, IN(Finish) finish, Vec3 n, Bool in_sight) {
  Float r = pane_reflectance(facing_here(n), u.glass_ior) * u.coat;
  Float left = 1.0f - r;
  if (u.is_pane != 0) left = left / (1.0f + r);
  left = sel(in_sight, left, Float(1.0f));
  Answer answer;
  answer.albedo = base * ((1.0f - finish.metallic) * left);
  answer.reflectance = base * (finish.metallic * left);
  answer.shown = Float(1.0f);
  return answer;
}

// A surface as its layer shows it. `in_sight`: it is the nearest glass.
Answer in_layer(IN(Answer) whole, Vec4 base, IN(Finish) finish, Vec3 n, Bool in_sight) {
  Answer answer = whole;
  answer.shown = base.w;
  if (u.is_partly_diffuse != 0) {
    answer = under_glass(Vec3(base), finish, n, in_sight);
    answer.shown = 1.0f - layer_passes(layer_here(base.w));
  }
  return answer;
}

// Of a fragment that is drawn.
void write_surface(Vec3 n, IN(SeenUv) seen, Vec4 base, Float z) {
  Bool from_behind = !front_facing();
  view_lift = Vec4(Float(0.0f), Float(0.0f), Float(0.0f), Float(0.0f));
  if (u.has_lift != 0) view_lift = Vec4(lift_along(n, from_behind), Float(0.0f));
  Vec3 shading = n;
  if (u.normal_use.levels > 0) shading = textured_normal(n, seen);
  // A surface seen from behind shows its other side: the textured normal as a whole is reversed.
  shading = sel(from_behind, -shading, shading);

  Vec3 emission = Vec3(u.emissive_factor);
  if (u.emissive_use.levels > 0)
    emission = emission * Vec3(fetch_seen(emissive, emissive_levels, u.emissive_use, seen));
  Float place = Float(1.0f);
  if (u.layer != 0) place = sel(before_glass(z), Float(u.is_partly_diffuse != 0 ? 3.0f : 2.0f), place);
  view_position = Vec4(surface_position, place);
  view_normal = Vec4(shading, z);
  Finish finish = finish_here(seen);
  Answer answer = coated(Vec3(base), finish, shading);
  answer.shown = shown_here();
  if (u.layer != 0) answer = in_layer(answer, base, finish, n, place > 1.5f);
  view_albedo = Vec4(answer.albedo, answer.shown);
  view_specular = Vec4(answer.reflectance, finish.roughness);
  view_emission = Vec4(emission, Float(1.0f));
  view_ambient = ambient_share(seen);
}

void main() {
  Vec3 n = normalize_or(surface_normal, Vec3(0.0f, 1.0f, 0.0f));
  SeenUv seen = seen_here(n);
  Vec4 base = base_factor_here();
  if (u.base_color_use.levels > 0)
    base = base * fetch_seen(base_color, base_color_levels, u.base_color_use, seen);
  Float z = view_coordinates(u.view, surface_position).z;
  Float coverage = base.w;
  Bool left_out = finest_opacity() < u.alpha_cutoff;
  if (u.layer != 0) {
    Bool blended = left_out;
    if (u.is_partly_diffuse != 0) {
      coverage = 1.0f - layer_passes(layer_here(base.w));
      blended = !left_out;
    }
    left_out = !blended || coverage <= 0.0f || not_in_layer(z);
  }
  if (u.is_double_sided == 0) left_out = left_out || !front_facing();
  discard_if(left_out);
  if (any_lane(!left_out)) write_surface(n, seen, base, z);
}
#endif
