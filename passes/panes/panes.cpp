#include "passes/panes/panes.hpp"

#include "passes/shared/material_uniforms.hpp"
#include "passes/shared/sky_uniforms.hpp"

namespace caustics::std140 {

struct Pane {
#include "passes/panes/pane_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader pane_light_shader;
extern const Shader view_panes_shader;

namespace {

// Without what shadows a light.
std140::Pane pane_uniforms(const View& view, const glm::dvec3& eye, const PassContext& context) {
  const Material& m = *context.material;
  return {.sky = shader_sky(context.scene->environment),
          .view = shader_view(view),
          .side = view.cube ? static_cast<float>(view.cube->side) : 0.0f,
          .shows_mirror = 0,
          .eye = glm::vec3(eye),
          .forward = glm::vec3(view.forward),
          .color = glm::vec3(m.base_color) * m.transmission,
          .ior = m.ior,
          .has_base_color = m.base_color_texture.present() ? 1 : 0,
          .base_color_uv = std140::texture_transform(m.base_color_texture),
          .alpha_mask = std140::alpha_mask(m),
          .shadow_view = {},
          .has_shadow_map = 0};
}

UniformBytes light_uniforms(const PassContext& context) {
  const LightViews& views = *context.views;
  std140::Pane u = pane_uniforms(views.panes, context.light->position, context);
  u.shadow_view = shader_view(views.shadow);
  u.has_shadow_map = context.effects->occluders.active ? 1 : 0;
  return uniform_bytes(u);
}

UniformBytes view_uniforms(const PassContext& context) {
  return uniform_bytes(pane_uniforms(*context.camera, context.camera->origin, context));
}

UniformBytes mirror_uniforms(const PassContext& context) {
  std140::Pane u = pane_uniforms(*context.camera, context.camera->origin, context);
  u.shows_mirror = 1;
  return uniform_bytes(u);
}

PassDefinition view_definition(const char* name, const char* purpose, BlendState blend) {
  return {.name = name,
          .purpose = purpose,
          .reads = {{.name = "base_color", .meaning = "the pane's tint", .of_material = true},
                    {.name = "view_position", .meaning = "opaque surfaces"},
                    {.name = "view_normal", .meaning = "their depth"},
                    {.name = "view_caster_position", .meaning = "glass", .optional = true},
                    {.name = kEnvironment,
                     .meaning = "radiance from all around",
                     .optional = true}},
          .writes = {{.name = "beauty",
                      .meaning = "rgb: radiance towards the camera, nit; a: 1",
                      .blend = blend,
                      .mask = {true, true, true, false}}},
          .shader = &view_panes_shader};
}

std::optional<std::string> seen(const Effects& effects) {
  if (!effects.thin_panes.active) return {};
  return "the camera may look through a thin pane";
}

}  // namespace

Pass pane_light_pass() {
  return {.definition =
              {.name = "pane_light",
               .purpose = "finds what thin panes leave of the light that passes straight through them",
               .reads = {{.name = "base_color", .meaning = "the pane's tint", .of_material = true},
                         {.name = "shadow_depth",
                          .meaning = "opaque surfaces, behind which panes no longer count",
                          .optional = true}},
               .writes = {{.name = "pane_transmittance",
                           .meaning = "rgb: what all panes together let through, 0..1; a: 1",
                           .clear = {1.0f, 1.0f, 1.0f, 1.0f},
                           .blend = kMultiply}},
               .shader = &pane_light_shader},
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            if (!effects.light.active || !effects.thin_panes.active) return {};
            return "thin panes tint the light that passes them";
          },
          .each = Each::Light,
          .draws = DrawSet::ThinPanes,
          .extent = Extent::Shadow,
          .uniforms = light_uniforms};
}

Pass view_panes_pass() {
  return {.definition = view_definition("view_panes", "tints what is seen through thin panes", kMultiply),
          .called_for_by = seen,
          .draws = DrawSet::ThinPanes,
          .extent = Extent::Picture,
          .uniforms = view_uniforms};
}

Pass view_pane_mirror_pass() {
  return {.definition = view_definition("view_pane_mirror",
                                        "adds the environment that thin panes mirror", kAccumulate),
          .called_for_by = seen,
          .draws = DrawSet::ThinPanes,
          .extent = Extent::Picture,
          .uniforms = mirror_uniforms};
}

}  // namespace caustics
