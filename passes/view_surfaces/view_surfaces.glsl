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
TEXTURE(5, behind)
TEXTURE(6, before)
TEXTURE(7, glass)
#include "passes/shared/tangent_vertex.glsl"
VARYING_SMOOTH(10, Vec2, surface_uv)
VARYING_SMOOTH(12, Float, tangent_plane_height)  // of the vertex's, over the origin

#ifdef VERTEX_STAGE
void main() {
  place_surface();
  surface_uv = uv;
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
#include "passes/shared/material.glsl"
#include "passes/shared/transformed_uv.glsl"
#include "passes/shared/tangent_space.glsl"

Vec3 textured_normal(Vec3 n) {
  Vec2 uv = transformed_uv(u.normal_uv, surface_uv);
  Vec4 texel = fetch_repeat(normal_texture, uv.x, uv.y);
  return leaned_normal(n, surface_tangent, tangent_space_normal(texel, Float(u.normal_scale)));
}

// How rough the surface is, and how much of it is metal.
struct Finish {
  Float roughness;
  Float metallic;
};

Finish finish_here() {
  Finish f;
  f.roughness = Float(u.roughness);
  f.metallic = Float(u.metallic);
  if (u.has_metallic_roughness != 0) {
    Vec2 at = transformed_uv(u.metallic_roughness_uv, surface_uv);
    Vec4 texel = fetch_repeat(metallic_roughness, at.x, at.y);
    f.roughness = f.roughness * texel.y;
    f.metallic = f.metallic * texel.z;
  }
  return f;
}

Float ambient_share() {
  Float share = Float(1.0f);
  if (u.has_occlusion != 0) {
    Vec2 at = transformed_uv(u.occlusion_uv, surface_uv);
    Vec4 texel = fetch_repeat(occlusion, at.x, at.y);
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
Vec3 lift_along(Vec3 n, Bool behind) {
  Float height = tangent_plane_height - dot3(surface_position, surface_normal);
  Float towards_viewer = sel(behind, -height, height);
  Float rounding = 1.0e-5f * (abs(surface_position.x) + abs(surface_position.y) + abs(surface_position.z));
  return n * sel(towards_viewer > rounding, height, Float(0.0f));
}

// Does this fragment lie before the glass or metal in its pixel?
Bool before_glass(Float z) {
  // What the frame lacks is one texel of zeros.
  Vec4 caster = fetch_clamped(glass, floor_to_int(frag_x()), floor_to_int(frag_y()));
  return is_covered(caster) && z < view_coordinates(u.view, Vec3(caster)).z;
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

void main() {
  Vec2 uv = transformed_uv(u.base_color_uv, surface_uv);
  Vec4 base = Vec4(u.base_factor);
  if (u.has_base_color != 0) base = base * fetch_repeat(base_color, uv.x, uv.y);
  Float opacity = base.w;
  Float z = view_coordinates(u.view, surface_position).z;
  Bool left_out = opacity < u.alpha_cutoff;
  if (u.layer != 0) left_out = !left_out || opacity <= 0.0f || not_in_layer(z);
  discard_if(left_out);

  Vec3 n = normalize_or(surface_normal, Vec3(0.0f, 1.0f, 0.0f));
  Bool behind = !front_facing();
  view_lift = Vec4(lift_along(n, behind), Float(0.0f));
  if (u.has_normal != 0) n = textured_normal(n);
  // A surface seen from behind shows its other side: the textured normal as a whole is reversed.
  n = sel(behind, -n, n);

  Vec3 emission = Vec3(u.emissive_factor);
  if (u.has_emissive != 0) {
    Vec2 at = transformed_uv(u.emissive_uv, surface_uv);
    emission = emission * Vec3(fetch_repeat(emissive, at.x, at.y));
  }
  Float place = Float(1.0f);
  if (u.layer != 0) place = sel(before_glass(z), Float(2.0f), place);
  view_position = Vec4(surface_position, place);
  view_normal = Vec4(n, z);
  Finish finish = finish_here();
  Vec3 albedo = Vec3(base) * (1.0f - finish.metallic);
  Float shown = shown_here();
  if (u.layer != 0) shown = opacity;
  view_albedo = Vec4(albedo, shown);
  Vec3 reflectance = Vec3(base) * finish.metallic + Vec3(u.dielectric * (1.0f - finish.metallic));
  view_specular = Vec4(reflectance, finish.roughness);
  view_emission = Vec4(emission, Float(1.0f));
  view_ambient = ambient_share();
}
#endif
