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

// Without glass before it the shaded scene is the picture.
std::string_view shaded(const Effects& effects) { return effects.seen_casters.active ? "scene_color" : "beauty"; }

}  // namespace

Pass compose_pass() {
  return {
      .name = "compose",
      .purpose = "shades diffuse surfaces under all their light, before the sky",
      .reason = "the camera sees the surfaces, and glass shows what lies beyond the picture's edges",
      .drawn_for = {kFrame, kSurroundings},
      .reads = {{.name = "view_position", .meaning = "the surfaces"},
                {.name = "view_normal", .meaning = "their normals"},
                {.name = "view_albedo", .meaning = "their colours"},
                {.name = "view_emission", .meaning = "their own light"},
                {.name = "direct", .meaning = "direct irradiance, lux", .optional = true},
                {.name = "caustic", .meaning = "caustic irradiance, lux", .optional = true},
                {.name = kEnvironment, .meaning = "radiance from all around", .optional = true}},
      .writes = {{.name = "scene_color",
                  .meaning = "rgb: radiance towards the camera, nit; a: 1",
                  .texture_by = shaded}},
      .shaders = {{&compose_shader}},
      .uniforms = [](const PassContext& c) { return uniforms(*c.camera, c.width, c.height, c); },
  };
}

}  // namespace caustics
