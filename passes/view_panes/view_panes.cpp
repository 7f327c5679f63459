#include "passes/view_panes/view_panes.hpp"

#include "passes/shared/pane_uniforms.hpp"

namespace caustics {

extern const Shader view_panes_shader;

namespace {

constexpr DrawnFor kMirrored{
    .label = "mirrored", .own_textures = false, .reason = "thin panes mirror the environment"};

constexpr DrawnFor kLit{.each = Each::Light,
                        .label = "lit",
                        .own_textures = false,
                        .also = &Effects::highlights,
                        .reason = "thin panes mirror the light"};

std140::Pane view_panes_uniforms(const PassContext& context) {
  std140::Pane u = pane_uniforms(*context.camera, context.camera->origin, context);
  if (context.light) u.light = shader_light(*context.light, context.views->shadow.forward);
  return u;
}

int shows_mirror(const PassContext& context) {
  return context.drawn_for && !context.drawn_for->label.empty() ? 1 : 0;
}

int shows_light(const PassContext& context) { return context.light ? 1 : 0; }

}  // namespace

Pass view_panes_pass() {
  return {
      .name = "view_panes",
      .purpose = "tints what is seen through thin panes, and adds what they mirror of environment and lights",
      .reason = "the camera may look through a thin pane",
      .when = {&Effects::thin_panes},
      .drawn_for = {kFrame, kMirrored, kLit},
      .draws = DrawSet::ThinPanes,
      .reads = {{.name = "base_color", .meaning = "the pane's tint", .of_material = true},
                {.name = "view_position", .meaning = "opaque surfaces"},
                {.name = "view_normal", .meaning = "their depth"},
                {.name = "view_caster_position",
                 .meaning = "glass",
                 .texture = "caster_position.camera",
                 .optional = true},
                {.name = kEnvironment, .meaning = "radiance from all around", .optional = true},
                {.name = "transmission_texture", .meaning = "r: transmission", .of_material = true}},
      .writes = {{.name = "beauty",
                  .meaning = "rgb: radiance towards the camera, nit; a: 1",
                  .blend = kMultiply,
                  .mask = {true, true, true, false}}},
      .owner = Each::Frame,
      // What panes mirror is added to what they let through.
      .states = {{.label = kMirrored.label, .blend = kAccumulate},
                 {.label = kLit.label, .blend = kAccumulate}},
      .shaders = {{&view_panes_shader, block_of<view_panes_uniforms>}},
      .choices = {{"shows_mirror", shows_mirror}, {"shows_light", shows_light}},
  };
}

}  // namespace caustics
