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
          .side = view.cube ? view.cube->side : 0,
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

constexpr DrawnFor kMirrored{.label = "mirrored", .own_textures = false};

UniformBytes view_uniforms(const PassContext& context) {
  std140::Pane u = pane_uniforms(*context.camera, context.camera->origin, context);
  u.shows_mirror = context.drawn_for && context.drawn_for->label == kMirrored.label;
  return uniform_bytes(u);
}

// What panes mirror is added to what they let through.
void add_when_mirrored(const DrawnFor& drawn_for, PassDefinition& definition) {
  if (drawn_for.label == kMirrored.label) definition.writes[0].blend = kAccumulate;
}

}  // namespace

Pass pane_light_pass() {
  return {
      .name = "pane_light",
      .purpose = "finds what thin panes leave of the light that passes straight through them",
      .reason = "thin panes tint the light that passes them",
      .when = {&Effects::light, &Effects::thin_panes},
      .drawn_for = {kLight},
      .draws = DrawSet::ThinPanes,
      .size = shadow_size,
      .reads = {{.name = "base_color", .meaning = "the pane's tint", .of_material = true},
                {.name = "shadow_depth",
                 .meaning = "opaque surfaces, behind which panes no longer count",
                 .optional = true}},
      .writes = {{.name = "pane_transmittance",
                  .meaning = "rgb: what all panes together let through, 0..1; a: 1",
                  .clear = {1.0f, 1.0f, 1.0f, 1.0f},
                  .blend = kMultiply}},
      .shaders = {{&pane_light_shader}},
      .uniforms = light_uniforms,
  };
}

Pass view_panes_pass() {
  return {
      .name = "view_panes",
      .purpose = "tints what is seen through thin panes, and adds the environment that they mirror",
      .reason = "the camera may look through a thin pane",
      .when = {&Effects::thin_panes},
      .drawn_for = {kFrame, kMirrored},
      .draws = DrawSet::ThinPanes,
      .reads = {{.name = "base_color", .meaning = "the pane's tint", .of_material = true},
                {.name = "view_position", .meaning = "opaque surfaces"},
                {.name = "view_normal", .meaning = "their depth"},
                {.name = "view_caster_position",
                 .meaning = "glass",
                 .texture = "caster_position.camera",
                 .optional = true},
                {.name = kEnvironment, .meaning = "radiance from all around", .optional = true}},
      .writes = {{.name = "beauty",
                  .meaning = "rgb: radiance towards the camera, nit; a: 1",
                  .blend = kMultiply,
                  .mask = {true, true, true, false}}},
      .otherwise = add_when_mirrored,
      .shaders = {{&view_panes_shader}},
      .uniforms = view_uniforms,
  };
}

}  // namespace caustics
