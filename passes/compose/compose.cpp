#include "passes/compose/compose.hpp"

#include <glm/glm.hpp>

#include "passes/compose/environment_irradiance.hpp"
#include "passes/shared/camera_rays.hpp"
#include "passes/shared/sky_uniforms.hpp"

namespace caustics::std140 {

struct Compose {
#include "passes/compose/compose_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader compose_shader;

namespace {

UniformBytes uniforms(const View& view, int width, int height, const PassContext& context) {
  const Environment& environment = context.scene->environment;
  const std::array<glm::vec3, 9> ambient =
      environment.image ? environment_irradiance(*environment.image) : std::array<glm::vec3, 9>{};
  return uniform_bytes(std140::Compose{
      .sky = shader_sky(environment),
      .camera = shader_camera_rays(view, width, height),
      .ambient_0 = ambient[0],
      .ambient_1 = ambient[1],
      .ambient_2 = ambient[2],
      .ambient_3 = ambient[3],
      .ambient_4 = ambient[4],
      .ambient_5 = ambient[5],
      .ambient_6 = ambient[6],
      .ambient_7 = ambient[7],
      .ambient_8 = ambient[8],
  });
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
