#include "passes/light_haze/light_haze.hpp"

#include "passes/shared/camera_rays.hpp"
#include "passes/shared/light_uniforms.hpp"
#include "passes/shared/medium_uniforms.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::std140 {

struct LightHaze {
#include "passes/light_haze/light_haze_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader light_haze_shader;

namespace {

std140::LightHaze light_uniforms(const PassContext& context) {
  const LightViews& views = *context.views;
  return {
      .camera = shader_camera_rays(*context.camera, context.width, context.height),
      .medium = shader_medium(*context.scene),
      .light = shader_light(*context.light, views.shadow.forward),
      .shadow_view = shader_view(views.shadow),
      .caster_view = shader_view(views.caster),
      .pane_view = shader_view(views.panes),
      .steps = context.settings->medium_steps,
  };
}

}  // namespace

Pass light_haze_pass() {
  return {
      .name = "light_haze",
      .purpose = "adds up what the medium scatters of a light's direct light",
      .reason = "the medium scatters the light",
      .when = {&Effects::scattering},
      .drawn_for = {kLight},
      .reads = {{.name = "view_range", .meaning = "how far each ray goes"},
                {.name = "shadow_depth", .meaning = "what shadows the medium", .optional = true},
                {.name = "caster_position", .meaning = "the casters, which do too", .optional = true},
                {.name = "pane_transmittance", .meaning = "what thin panes let through", .optional = true},
                {.name = "shadow_bounds", .meaning = "where the shadow map is even"},
                {.name = "caster_bounds", .meaning = "likewise, the casters"},
                {.name = "pane_bounds", .meaning = "likewise, the panes"}},
      .writes = {{.name = "haze",
                  .meaning = "rgb: radiance that the medium scatters towards the camera, nit",
                  .blend = kAccumulate}},
      .owner = Each::Frame,
      .shaders = {{&light_haze_shader, block_of<light_uniforms>}},
      .choices = {{"has_shadow_map", chosen_by<&Effects::occluders>},
                  {"has_caustic", throws_caustic},
                  {"has_panes", chosen_by<&Effects::tinted_light>}},
  };
}

}  // namespace caustics
