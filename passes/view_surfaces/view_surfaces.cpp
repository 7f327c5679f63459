#include "passes/view_surfaces/view_surfaces.hpp"

#include <algorithm>
#include <cmath>

#include "passes/shared/material_uniforms.hpp"
#include "pipeline/scene/material_optics.hpp"
#include "pipeline/scene/mip_levels.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::std140 {

struct ViewSurfaces {
#include "passes/view_surfaces/view_surfaces_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader view_surfaces_shader;

namespace {

// Of a picture's pixel, or of what each of its samples stands for.
float pixel_side(const PassContext& context) {
  if (!has_mip_map(*context.material)) return 0.0f;
  const double width = context.camera->window_upper.x - context.camera->window_lower.x;
  const int samples = context.settings ? samples_a_pixel(*context.settings) : 1;
  return static_cast<float>(width / context.width / std::sqrt(static_cast<double>(samples)));
}

std140::ViewSurfaces view_surfaces_uniforms(const PassContext& context) {
  const Material& m = *context.material;
  const SurfaceRole role = context.surface_role();
  // What metal mirrors is shown with the highlights; without them it is drawn as diffuse.
  const bool mirrors = context.effects && context.effects->highlights.active;
  const bool textured = mirrors && m.metallic_roughness_texture.present();
  const float metallic = textured ? m.metallic_factor : m.metallic;
  return {
      .view = shader_view(*context.camera),
      .base_factor = m.base_color,
      .alpha_cutoff = role.partly_diffuse ? std140::alpha_mask(m).cutoff : opaque_from(m),
      .pixel_side = pixel_side(context),
      .has_colors = context.mesh && !context.mesh->colors.empty() ? 1 : 0,
      .is_double_sided = m.double_sided || (context.mesh && context.mesh->inside_out) ? 1 : 0,
      .normal_scale = m.normal_scale,
      .emissive_factor = m.emissive,
      .fade_centre = m.fade.centre,
      .fade_from = m.fade.from,
      .fade_to = m.fade.to,
      .metallic = mirrors && !m.unlit ? metallic : 0.0f,
      .dielectric = m.unlit ? glm::vec3(0.0f) : dielectric_reflectance(m),
      .coat = m.fresnel_factor,
      .is_coated = mirrors && !m.unlit ? 1 : 0,
      .roughness = textured ? m.roughness_factor : m.roughness,
      .base_color_use = std140::surface_texture(m.base_color_texture),
      .normal_use = std140::surface_texture(m.normal_texture),
      .emissive_use = std140::surface_texture(m.emissive_texture),
      .metallic_roughness_use =
          std140::surface_texture(textured ? m.metallic_roughness_texture : TextureUse{}),
      .occlusion_use = std140::surface_texture(m.unlit ? TextureUse{} : m.occlusion_texture),
      .occlusion_strength = m.occlusion_strength,
      .is_partly_diffuse = role.partly_diffuse ? 1 : 0,
      .is_pane = role.role == Role::ThinPane ? 1 : 0,
      .glass_ior = m.ior,
      .is_covering = role.role == Role::ThinPane && m.alpha_mode == AlphaMode::Blend ? 1 : 0,
      .transmitted = transmission_factor(m),
      .has_transmission = m.transmission_texture.present() ? 1 : 0,
      .transmission_uv = std140::texture_transform(m.transmission_texture),
  };
}

}  // namespace

Pass view_surfaces_pass() {
  return {
      .name = "view_surfaces",
      .purpose = "finds the first opaque surface in each pixel, and the nearest blended ones",
      .reason = "the camera looks at the scene",
      .drawn_for = with_layers({kFrame}),
      .draws = DrawSet::Receivers,
      .reads = {{.name = "base_color", .meaning = "albedo and opacity", .of_material = true},
                {.name = "normal_texture", .meaning = "tangent-space normals", .of_material = true},
                {.name = "emissive", .meaning = "light of its own", .of_material = true},
                {.name = "metallic_roughness", .meaning = "g: roughness, b: metallic", .of_material = true},
                {.name = "occlusion", .meaning = "r: the share of ambient light", .of_material = true},
                {.name = "base_color_levels", .meaning = "mip map of it", .of_material = true},
                {.name = "normal_levels", .meaning = "likewise", .of_material = true},
                {.name = "emissive_levels", .meaning = "likewise", .of_material = true},
                {.name = "metallic_roughness_levels", .meaning = "likewise", .of_material = true},
                {.name = "occlusion_levels", .meaning = "likewise", .of_material = true},
                {.name = "behind",
                 .meaning = "of a layer: what it lies before",
                 .texture = "view_normal",
                 .optional = true,
                 .layer = OfLayer::Behind},
                {.name = "before",
                 .meaning = "of a layer: the next nearer one",
                 .texture = "view_normal",
                 .layers_discard_where_zero = true,
                 .optional = true,
                 .layer = OfLayer::Before},
                {.name = "glass",
                 .meaning = "of a layer: glass and metal",
                 .texture = "caster_position.camera",
                 .optional = true,
                 .layer = OfLayer::Behind},
                {.name = "transmission_texture", .meaning = "r: transmission", .of_material = true}},
      .writes = {{.name = "view_position",
                  .meaning = "xyz: position of the first opaque surface, metres, scene space; w: 1 "
                             "where there is one, else 0; 2: a blended one before glass"},
                 {.name = "view_normal",
                  .meaning = "xyz: unit shading normal on the camera's side, scene space; w: depth "
                             "along the camera's axis, metres"},
                 {.name = "view_albedo",
                  .meaning = "rgb: diffuse albedo, linear; a: how much of the surface is shown, "
                             "less than 1 where an added ground fades or a surface is blended"},
                 {.name = "view_specular",
                  .meaning = "rgb: reflectance at normal incidence; a: roughness",
                  .needed_if = with<&Effects::highlights>},
                 {.name = "view_emission",
                  .meaning = "rgb: emitted radiance, nit",
                  .needed_if = with<&Effects::emission>},
                 {.name = "view_lift",
                  .meaning = "xyz: from the triangle out to the tangent planes of its vertices, metres",
                  .needed_if = with<&Effects::smooth_shading>},
                 {.name = "view_ambient",
                  .format = Format::R32F,
                  .meaning = "the share of the environment's light that arrives",
                  .needed_if = with<&Effects::occlusion>}},
      .depth = DepthWrite{.name = "view_window_depth", .meaning = "window depth"},
      .depth_state = {.compare = Compare::Less, .write = true},
      .count_samples = true,
      .shaders = {{&view_surfaces_shader, block_of<view_surfaces_uniforms>}},
      .choices = {{"layer", [](const PassContext& c) { return std::min(c.layer(), 2); }},
                  {"has_lift", chosen_by<&Effects::smooth_shading>}},
  };
}

}  // namespace caustics
