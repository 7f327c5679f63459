#include "passes/compose/compose.hpp"

#include <algorithm>
#include <glm/glm.hpp>

#include "passes/shared/camera_rays.hpp"
#include "passes/shared/layer_reads.hpp"
#include "passes/shared/sky_uniforms.hpp"

namespace caustics::std140 {

struct Compose {
#include "passes/compose/compose_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader compose_shader;

namespace {

std140::Compose compose_uniforms(const PassContext& context) {
  const Environment& environment = context.scene->environment;
  const std::array<glm::vec3, 9>& ambient = environment.ambient;
  return {
      .sky = shader_sky(environment),
      .camera = shader_camera_rays(*context.camera, context.width, context.height),
      .boxes_mean = environment.boxes_mean,
      .ambient_0 = ambient[0],
      .ambient_1 = ambient[1],
      .ambient_2 = ambient[2],
      .ambient_3 = ambient[3],
      .ambient_4 = ambient[4],
      .ambient_5 = ambient[5],
      .ambient_6 = ambient[6],
      .ambient_7 = ambient[7],
      .ambient_8 = ambient[8],
  };
}

// Neither of what blended surfaces show nor of what only glass does.
int has_ambient_occlusion(const PassContext& context) {
  return context.of_picture() && context.layer() == 0 && context.effects->ambient_occlusion.active ? 1 : 0;
}

// Over the picture that glass is drawn into, `glass` lays them.
int blends(const PassContext& context) {
  const bool in_glass = context.effects->seen_casters.active && context.layer() == 0;
  return in_glass ? 0 : of_picture<&Effects::layered>(context);
}

// Without glass before it the shaded scene is the picture.
std::string_view shaded(const Effects& effects) {
  return effects.seen_casters.active ? "scene_color" : "beauty";
}

}  // namespace

Pass compose_pass() {
  return {
      .name = "compose",
      .purpose = "shades diffuse surfaces under all their light, before the sky",
      .reason = "the camera sees the surfaces",
      .drawn_for = with_layers({kFrame, kHiddenBehind, kHiddenMirrored}),
      .reads = {{.name = "view_position", .meaning = "the surfaces", .hidden_discard_where_zero = true},
                {.name = "view_normal", .meaning = "their normals"},
                {.name = "view_albedo", .meaning = "their colours"},
                {.name = "view_emission", .meaning = "their own light", .optional = true},
                {.name = "direct",
                 .meaning = "direct irradiance, lux",
                 .optional = true,
                 .needed_with = &Effects::reflecting_receivers},
                {.name = "caustic",
                 .meaning = "caustic irradiance, lux",
                 .optional = true,
                 .needed_with = &Effects::reflecting_receivers},
                {.name = kEnvironment, .meaning = "radiance from all around", .optional = true},
                {.name = "highlight",
                 .meaning = "what it mirrors of the lights, nit",
                 .optional = true,
                 .of_picture = true,
                 .needed_with = &Effects::highlights},
                {.name = "view_specular",
                 .meaning = "how the surfaces mirror",
                 .optional = true,
                 .of_picture = true,
                 .needed_with = &Effects::highlights},
                {.name = "view_ambient",
                 .meaning = "the share of the environment's light that arrives",
                 .optional = true,
                 .of_picture = true,
                 .needed_with = &Effects::occlusion},
                kReadLayers,
                kReadFirstLayer,
                {.name = "ambient_occlusion",
                 .meaning = "the share that other surfaces leave of it, coarsely",
                 .optional = true,
                 .of_picture = true,
                 .needed_with = &Effects::ambient_occlusion}},
      .writes = {{.name = "scene_color",
                  .meaning = "rgb: radiance towards the camera, nit; a: 1; of a layer, and behind glass: how "
                             "much passes it",
                  .clear = {0.0f, 0.0f, 0.0f, 1.0f},
                  .texture_by = shaded}},
      .shaders = {{&compose_shader, block_of<compose_uniforms>}},
      .choices = {{"layer", [](const PassContext& c) { return std::min(c.layer(), 2); }},
                  {"blends", blends},
                  {"mirrors", of_picture<&Effects::highlights>},
                  {"is_occluded", of_picture<&Effects::occlusion>},
                  {"behind_glass", [](const PassContext& c) { return c.of_picture() ? 0 : 1; }},
                  {"has_ambient_occlusion", has_ambient_occlusion}},
  };
}

}  // namespace caustics
