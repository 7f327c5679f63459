#include "passes/compose/compose.hpp"

#include <glm/glm.hpp>

#include "passes/compose/environment_irradiance.hpp"
#include "passes/shared/sky_uniforms.hpp"

namespace caustics {

extern const Shader compose_shader;

namespace {

struct ComposeUniforms {
  using vec4 = glm::vec4;
#include "passes/compose/compose_uniforms.glsl"
};

UniformBytes uniforms(const View& view, int width, int height, const PassContext& context) {
  const Environment& environment = context.scene->environment;
  const SkyUniforms sky = sky_uniforms(environment);
  const glm::dvec2 size = view.window_upper - view.window_lower;
  const std::array<glm::vec3, 9> ambient =
      environment.image ? environment_irradiance(*environment.image) : std::array<glm::vec3, 9>{};
  ComposeUniforms u{
      .sky_zenith = sky.zenith,
      .sky_horizon = sky.horizon,
      .sky_ground = sky.ground,
      .right = glm::vec4(glm::vec3(view.right), 0.0f),
      .up = glm::vec4(glm::vec3(view.up), 0.0f),
      .forward = glm::vec4(glm::vec3(view.forward), view.perspective ? 1.0f : 0.0f),
      .pixel = {static_cast<float>(size.x / width),
                static_cast<float>(size.y / height),
                static_cast<float>(view.window_lower.x), static_cast<float>(view.window_lower.y)},
      .ambient_0 = glm::vec4(ambient[0], 0.0f),
      .ambient_1 = glm::vec4(ambient[1], 0.0f),
      .ambient_2 = glm::vec4(ambient[2], 0.0f),
      .ambient_3 = glm::vec4(ambient[3], 0.0f),
      .ambient_4 = glm::vec4(ambient[4], 0.0f),
      .ambient_5 = glm::vec4(ambient[5], 0.0f),
      .ambient_6 = glm::vec4(ambient[6], 0.0f),
      .ambient_7 = glm::vec4(ambient[7], 0.0f),
      .ambient_8 = glm::vec4(ambient[8], 0.0f),
  };
  return uniform_bytes(u);
}

PassDefinition definition(const std::string& name, const std::string& view,
                          const std::string& light, const std::string& output) {
  return {
      .name = name,
      .purpose = "shades diffuse surfaces under all their light, before the sky",
      .reads = {{.name = view + "_position", .meaning = "the surfaces"},
                {.name = view + "_normal", .meaning = "their normals"},
                {.name = view + "_albedo", .meaning = "their colours"},
                {.name = view + "_emission", .meaning = "their own light"},
                {.name = light + "direct", .meaning = "direct irradiance, lux", .optional = true},
                {.name = light + "caustic", .meaning = "caustic irradiance, lux", .optional = true},
                {.name = kEnvironment, .meaning = "radiance from all around", .optional = true}},
      .writes = {{.name = output, .meaning = "rgb: radiance towards the camera, nit; a: 1"}},
      .shader = &compose_shader,
  };
}

}  // namespace

Pass compose_pass() {
  return {.definition = definition("compose", "view", "", "scene_color"),
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            if (!effects.seen_casters.active) return {};
            return "glass shows the scene behind it";
          },
          .extent = Extent::Picture,
          .uniforms = [](const PassContext& c) { return uniforms(*c.camera, c.width, c.height, c); }};
}

Pass compose_beauty_pass() {
  return {.definition = definition("compose_beauty", "view", "", "beauty"),
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            if (effects.seen_casters.active) return {};
            return "no glass stands before the scene";
          },
          .extent = Extent::Picture,
          .uniforms = [](const PassContext& c) { return uniforms(*c.camera, c.width, c.height, c); }};
}

Pass wide_compose_pass() {
  return {.definition = definition("wide_compose", "wide", "wide_", "wide_color"),
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            if (!effects.seen_casters.active) return {};
            return "glass shows what lies beyond the picture's edges";
          },
          .extent = Extent::Wide,
          .uniforms = [](const PassContext& c) { return uniforms(*c.surroundings, c.width, c.height, c); }};
}

}  // namespace caustics
