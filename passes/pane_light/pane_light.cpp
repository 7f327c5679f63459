#include "passes/pane_light/pane_light.hpp"

#include "passes/shared/material_uniforms.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "pipeline/scene/material_optics.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::std140 {

struct PaneLight {
#include "passes/pane_light/pane_light_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader pane_light_shader;

namespace {

constexpr DrawnFor kCasters{.each = Each::Light,
                            .label = "casters",
                            .size = grid_size,
                            .also = &Effects::tinted_caustics,
                            .reason = "panes and blended surfaces may stand between the light and casters"};

// Half the shadow map's side: panes have a window to themselves. A light that sees all around shares the
// shadow map's tiles.
TargetSize pane_size(const Settings& settings, const Effects&, const LightEffects* light) {
  const int side = light && !light->all_around.empty() ? int{settings.shadow} : (settings.shadow + 1) / 2;
  return {side, side};
}

int before_casters(const PassContext& context) {
  return context.drawn_for && context.drawn_for->label == kCasters.label ? 1 : 0;
}

std140::PaneLight pane_light_uniforms(const PassContext& context) {
  const LightViews& views = *context.views;
  const View& seen = before_casters(context) ? views.caster : views.panes;
  const Material& m = *context.material;
  const bool blended = context.surface_role().blended;
  return {.view = shader_view(seen),
          .map_side = seen.cube.value_or(CubeAtlas{}).side,
          .eye = glm::vec3(context.light->position),
          .forward = glm::vec3(seen.forward),
          .color = glm::vec3(m.base_color),
          .ior = m.ior,
          .fresnel = m.fresnel_factor,
          .transmitted = transmission_factor(m),
          .has_transmission = m.transmission_texture.present() ? 1 : 0,
          .transmission_uv = std140::texture_transform(m.transmission_texture),
          .is_covering = m.alpha_mode == AlphaMode::Blend ? 1 : 0,
          .has_base_color = m.base_color_texture.present() ? 1 : 0,
          .base_color_uv = std140::texture_transform(m.base_color_texture),
          .alpha_mask = blended ? std140::alpha_mask(m, kCoversAll) : std140::alpha_mask(m),
          .is_blended = blended ? 1 : 0,
          .shadow_view = shader_view(views.shadow)};
}

}  // namespace

Pass pane_light_pass() {
  return {
      .name = "pane_light",
      .purpose =
          "finds what thin panes and blended surfaces leave of the light that passes straight through them",
      .reason = "thin panes and blended surfaces tint the light that passes them",
      .when = {&Effects::light, &Effects::tinted_light},
      .drawn_for = {kLight, kCasters},
      .draws = DrawSet::LightTinters,
      .size = pane_size,
      .reads = {{.name = "base_color", .meaning = "the pane's tint", .of_material = true},
                {.name = "shadow_depth",
                 .meaning = "opaque surfaces, behind which panes no longer count",
                 .optional = true},
                {.name = "caster_position",
                 .meaning = "of casters: the grid vertices",
                 .optional = true,
                 .only_for = kCasters.label},
                {.name = "transmission_texture", .meaning = "r: transmission", .of_material = true}},
      .writes = {{.name = "pane_transmittance",
                  .meaning = "rgb: what all of them together let through, 0..1; a: 1",
                  .clear = {1.0f, 1.0f, 1.0f, 1.0f},
                  .blend = kMultiply}},
      .shaders = {{&pane_light_shader, block_of<pane_light_uniforms>}},
      .choices = {{"has_shadow_map", chosen_by<&Effects::occluders>}, {"before_casters", before_casters}},
  };
}

}  // namespace caustics
