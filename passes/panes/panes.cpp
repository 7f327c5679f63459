#include "passes/panes/panes.hpp"

#include <glm/glm.hpp>

#include "passes/shared/sky_uniforms.hpp"

namespace caustics {

extern const Shader pane_light_shader;
extern const Shader view_panes_shader;

namespace {

struct PaneUniforms {
  using vec4 = glm::vec4;
  using mat4 = glm::mat4;
#include "passes/panes/pane_uniforms.glsl"
};

PaneUniforms pane_uniforms(const View& view, const glm::dvec3& eye, const PassContext& context) {
  const ViewUniforms f = pack(view);
  const SkyUniforms sky = sky_uniforms(context.scene->environment);
  const Material& m = *context.material;
  const glm::mat3& uv = m.base_color_texture.uv_transform;
  const bool textured = m.base_color_texture.present();
  const bool masked = m.alpha_mode == AlphaMode::Mask;
  PaneUniforms u{};
  u.sky_zenith = sky.zenith;
  u.sky_horizon = sky.horizon;
  u.sky_ground = sky.ground;
  u.from_scene = f.from_scene;
  u.window = f.window;
  u.depth = f.depth;
  u.eye = glm::vec4(glm::vec3(eye), view.perspective ? 1.0f : 0.0f);
  u.forward = glm::vec4(glm::vec3(view.forward), 0.0f);
  u.tint = glm::vec4(glm::vec3(m.base_color) * m.transmission, m.ior);
  u.alpha = {m.base_color.a, masked ? m.alpha_cutoff : 0.0f, masked && textured ? 1.0f : 0.0f, 0.0f};
  u.uv_row0 = {uv[0][0], uv[1][0], uv[2][0], 0.0f};
  u.uv_row1 = {uv[0][1], uv[1][1], uv[2][1], 0.0f};
  u.uses.z = view.cube ? static_cast<float>(view.cube->side) : 0.0f;
  u.uses.x = textured ? 1.0f : 0.0f;
  return u;
}

UniformBytes light_uniforms(const PassContext& context) {
  const LightViews& views = *context.views;
  const ViewUniforms shadow = pack(views.shadow);
  PaneUniforms u = pane_uniforms(views.panes, context.light->position, context);
  u.uses.y = context.effects->occluders.active ? 1.0f : 0.0f;
  u.shadow_window = shadow.window;
  u.shadow_range = shadow.depth;
  return uniform_bytes(u);
}

UniformBytes view_uniforms(const PassContext& context) {
  return uniform_bytes(pane_uniforms(*context.camera, context.camera->origin, context));
}

UniformBytes mirror_uniforms(const PassContext& context) {
  PaneUniforms u = pane_uniforms(*context.camera, context.camera->origin, context);
  u.forward.w = 1.0f;
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
