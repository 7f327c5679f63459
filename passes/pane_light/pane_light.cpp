#include "passes/pane_light/pane_light.hpp"

#include "passes/shared/pane_uniforms.hpp"

namespace caustics {

extern const Shader pane_light_shader;

namespace {

std140::Pane pane_light_uniforms(const PassContext& context) {
  const LightViews& views = *context.views;
  std140::Pane u = pane_uniforms(views.panes, context.light->position, context);
  u.shadow_view = shader_view(views.shadow);
  return u;
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
      .shaders = {{&pane_light_shader, block_of<pane_light_uniforms>}},
      .choices = {{"has_shadow_map", chosen_by<&Effects::occluders>}},
  };
}

}  // namespace caustics
