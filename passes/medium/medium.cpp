#include "passes/medium/medium.hpp"

#include "passes/medium/medium_uniforms.hpp"
#include "passes/shared/camera_rays.hpp"
#include "passes/shared/light_uniforms.hpp"

namespace caustics::std140 {

struct ViewMedium {
#include "passes/medium/view_medium_uniforms.glsl"
};

struct LightHaze {
#include "passes/medium/light_haze_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader view_medium_shader;
extern const Shader light_haze_shader;
extern const Shader haze_shader;

namespace {

bool throws_caustic(const PassContext& context) {
  for (const Expectation& e : context.effects->expectations)
    if (e.expected && &context.scene->lights[static_cast<std::size_t>(e.light)] == context.light)
      return true;
  return false;
}

UniformBytes view_uniforms(const PassContext& context) {
  return uniform_bytes(
      std140::ViewMedium{.camera = shader_camera_rays(*context.camera, context.width, context.height),
                         .view = shader_view(*context.camera),
                         .medium = shader_medium(*context.scene)});
}

UniformBytes light_uniforms(const PassContext& context) {
  const LightViews& views = *context.views;
  return uniform_bytes(std140::LightHaze{
      .camera = shader_camera_rays(*context.camera, context.width, context.height),
      .medium = shader_medium(*context.scene),
      .light = shader_light(*context.light, views.shadow.forward),
      .shadow_view = shader_view(views.shadow),
      .caster_view = shader_view(views.caster),
      .pane_view = shader_view(views.panes),
      .has_shadow_map = context.effects->occluders.active ? 1 : 0,
      .has_caustic = throws_caustic(context) && context.effects->caustics.active ? 1 : 0,
      .has_panes = context.effects->thin_panes.active ? 1 : 0,
      .steps = context.settings->medium_steps,
  });
}

constexpr ColorMask kColor{true, true, true, false};

}  // namespace

Pass view_medium_pass() {
  return {
      .name = "view_medium",
      .purpose = "takes from the picture what the medium takes on the way to the camera",
      .reason = "a medium lies between the camera and what it sees",
      .when = {&Effects::medium},
      .reads = {{.name = "view_position", .meaning = "opaque surfaces"},
                {.name = "view_normal", .meaning = "their depth"},
                {.name = "view_caster_position", .meaning = "glass and mirrors", .texture = "caster_position.camera",
                 .optional = true}},
      .writes = {{.name = "beauty",
                  .meaning = "rgb: radiance towards the camera, nit; a: 1",
                  .blend = kMultiply,
                  .mask = kColor},
                 {.name = "view_range",
                  .meaning = "x: depth of the first surface along the camera's axis, metres, 1e30 where "
                             "there is none; y, z: distances from the camera at which its ray enters "
                             "the medium and leaves it or ends"}},
      .shaders = {{&view_medium_shader}},
      .uniforms = view_uniforms,
  };
}

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
                {.name = "pane_transmittance", .meaning = "what thin panes let through", .optional = true}},
      .writes = {{.name = "haze",
                  .meaning = "rgb: radiance that the medium scatters towards the camera, nit",
                  .blend = kAccumulate}},
      .owner = Each::Frame,
      .shaders = {{&light_haze_shader}},
      .uniforms = light_uniforms,
  };
}

Pass haze_pass() {
  return {
      .name = "haze",
      .purpose = "adds what the medium scatters to the picture",
      .reason = "the camera sees the scattered light",
      .when = {&Effects::scattering},
      .reads = {{.name = "haze", .meaning = "what it scatters, nit"}},
      .writes = {{.name = "beauty",
                  .meaning = "rgb: radiance towards the camera, nit; a: 1",
                  .blend = kAccumulate,
                  .mask = kColor}},
      .shaders = {{&haze_shader}},
      .uniforms = [](const PassContext&) { return UniformBytes{}; },
  };
}

}  // namespace caustics
