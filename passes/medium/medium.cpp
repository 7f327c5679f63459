#include "passes/medium/medium.hpp"

#include <cmath>

#include "passes/medium/light_haze_uniforms.hpp"
#include "passes/shared/light_uniforms.hpp"

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
  return with_medium(uniform_bytes(view_ray_uniforms(*context.camera, context.width, context.height)),
                     *context.scene);
}

UniformBytes light_uniforms(const PassContext& context) {
  const LightViews& views = *context.views;
  const Light& light = *context.light;
  const ViewUniforms caster = pack(views.caster), shadow = pack(views.shadow), panes = pack(views.panes);
  const LightCone cone = light_cone(light);
  const bool directional = light.type == LightType::Directional;
  const auto used = [&](Effect Effects::*effect) { return (context.effects->*effect).active ? 1.0f : 0.0f; };
  const UniformBytes own = uniform_bytes(LightHazeUniforms{
      .light_from_scene = shadow.from_scene,
      .caster_window = caster.window,
      .caster_depth = caster.depth,
      .shadow_window = shadow.window,
      .shadow_range = shadow.depth,
      .pane_window = panes.window,
      .pane_depth = panes.depth,
      .light = glm::vec4(glm::vec3(directional ? views.shadow.forward : light.position),
                         directional ? 0.0f : 1.0f),
      .cone_axis = cone.axis,
      .cone = cone.scale_offset,
      .intensity = glm::vec4(light.color * light.intensity,
                             !directional && std::isfinite(light.range) ? light.range : 0.0f),
      .uses = {used(&Effects::occluders), throws_caustic(context) ? used(&Effects::caustics) : 0.0f, used(&Effects::thin_panes), 0.0f},
      .steps = {context.settings->medium_steps, 0, 0, 0},
  });
  UniformBytes bytes = view_uniforms(context);
  bytes.insert(bytes.end(), own.begin(), own.end());
  return bytes;
}

constexpr ColorMask kColor{true, true, true, false};

}  // namespace

Pass view_medium_pass() {
  return {.definition =
              {.name = "view_medium",
               .purpose = "takes from the picture what the medium takes on the way to the camera",
               .reads = {{.name = "view_position", .meaning = "opaque surfaces"},
                         {.name = "view_normal", .meaning = "their depth"},
                         {.name = "view_caster_position", .meaning = "glass and mirrors", .optional = true}},
               .writes = {{.name = "beauty",
                           .meaning = "rgb: radiance towards the camera, nit; a: 1",
                           .blend = kMultiply,
                           .mask = kColor},
                          {.name = "view_range",
                           .meaning = "x: depth of the first surface along the camera's axis, metres, 1e30 where "
                                      "there is none; y, z: distances from the camera at which its ray enters "
                                      "the medium and leaves it or ends"}},
               .shader = &view_medium_shader},
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            if (!effects.medium.active) return {};
            return "a medium lies between the camera and what it sees";
          },
          .extent = Extent::Picture,
          .uniforms = view_uniforms};
}

Pass light_haze_pass() {
  return {.definition =
              {.name = "light_haze",
               .purpose = "adds up what the medium scatters of a light's direct light",
               .reads = {{.name = "view_range", .meaning = "how far each ray goes"},
                         {.name = "shadow_depth", .meaning = "what shadows the medium", .optional = true},
                         {.name = "caster_position", .meaning = "the casters, which do too", .optional = true},
                         {.name = "pane_transmittance",
                          .meaning = "what thin panes let through",
                          .optional = true}},
               .writes = {{.name = "haze",
                           .meaning = "rgb: radiance that the medium scatters towards the camera, nit",
                           .blend = kAccumulate}},
               .shader = &light_haze_shader},
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            if (!effects.scattering.active) return {};
            return "the medium scatters the light";
          },
          .each = Each::Light,
          .extent = Extent::Picture,
          .uniforms = light_uniforms,
          .owner = Each::Frame};
}

Pass haze_pass() {
  return {.definition = {.name = "haze",
                         .purpose = "adds what the medium scatters to the picture",
                         .reads = {{.name = "haze", .meaning = "what it scatters, nit"}},
                         .writes = {{.name = "beauty",
                                     .meaning = "rgb: radiance towards the camera, nit; a: 1",
                                     .blend = kAccumulate,
                                     .mask = kColor}},
                         .shader = &haze_shader},
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            if (!effects.scattering.active) return {};
            return "the camera sees the scattered light";
          },
          .extent = Extent::Picture,
          .uniforms = [](const PassContext&) { return UniformBytes{}; }};
}

}  // namespace caustics
