#include "passes/view_panes/view_panes.hpp"

#include "passes/shared/pane_uniforms.hpp"

namespace caustics {

extern const Shader view_panes_shader;

namespace {

constexpr DrawnFor kMirrored{
    .label = "mirrored", .own_textures = false, .reason = "thin panes mirror the environment"};

std140::Pane view_panes_uniforms(const PassContext& context) {
  return pane_uniforms(*context.camera, context.camera->origin, context);
}

int shows_mirror(const PassContext& context) {
  return context.drawn_for && context.drawn_for->label == kMirrored.label;
}

}  // namespace

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
      // What panes mirror is added to what they let through.
      .states = {{.label = kMirrored.label, .blend = kAccumulate}},
      .shaders = {{&view_panes_shader, block_of<view_panes_uniforms>}},
      .choices = {{"shows_mirror", shows_mirror}},
  };
}

}  // namespace caustics
