#include "passes/glass/glass.hpp"

#include "passes/caster_map/caster_map.hpp"
#include "passes/shared/layer_reads.hpp"
#include "passes/shared/receiver_search_uniforms.hpp"
#include "passes/shared/sky_uniforms.hpp"
#include "pipeline/effects/textured_casters.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::std140 {

struct Glass {
#include "passes/glass/glass_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader caster_map_shader;
extern const Shader caster_exit_map_shader;
extern const Shader glass_shader;

namespace {

std140::Glass glass_uniforms(const PassContext& context) {
  const Bounds receivers = receivers_box(context);
  return {
      .sky = shader_sky(context.scene->environment),
      .view = shader_view(*context.camera),
      .surroundings = shader_view(*context.surroundings),
      .eye = context.camera->origin,
      .iterations = 12,
      .forward = context.camera->forward,
      .receivers_lower = glm::vec3(receivers.lower),
      .receivers_upper = glm::vec3(receivers.upper),
      .rough_from = context.settings ? context.settings->glass_roughness : 1.0f,
  };
}

}  // namespace

Pass glass_pass() {
  return {
      .name = "glass",
      .purpose = "bends the view through refractive objects and mirrors it at their surface",
      .reason = "the camera may see a refractive object",
      .when = {&Effects::seen_casters},
      .unless = {&Effects::followed_view},
      .reads = {{.name = "scene_color", .meaning = "the picture without glass"},
                {.name = "view_position", .meaning = "where its surfaces are"},
                {.name = "wide_color",
                 .meaning = "the same over a wider view",
                 .texture = "scene_color.surroundings"},
                {.name = "wide_position",
                 .meaning = "where its surfaces are",
                 .texture = "view_position.surroundings"},
                {.name = "view_caster_position", .meaning = "the glass", .texture = "caster_position.camera"},
                {.name = "view_caster_normal",
                 .meaning = "its normals and materials",
                 .texture = "caster_normal.camera"},
                {.name = "view_exit_position",
                 .meaning = "its back faces",
                 .texture = "caster_exit_position.camera",
                 .optional = true},
                {.name = "view_exit_normal",
                 .meaning = "their normals",
                 .texture = "caster_exit_normal.camera",
                 .optional = true},
                {.name = kCasterMaterials, .meaning = "indices, absorption, tint"},
                {.name = kEnvironment, .meaning = "radiance from all around", .optional = true},
                {.name = "view_caster_tint",
                 .meaning = "the glass's colour, where textures give it",
                 .texture = "caster_tint.camera",
                 .optional = true},
                {.name = "caster_highlight",
                 .meaning = "what the first glass and metal mirror of the lights, nit",
                 .optional = true,
                 .needed_with = &Effects::highlights},
                kReadLayers,
                kReadFirstLayer},
      .writes = {{.name = "beauty", .meaning = "rgb: radiance towards the camera, nit; a: 1"}},
      .shaders = {{&glass_shader, block_of<glass_uniforms>}},
      .choices = {{"blends", chosen_by<&Effects::layered>},
                  {"has_rough", chosen_by<&Effects::rough_glass>},
                  {"has_caster_tint", chosen_by<&Effects::textured_casters>}},
  };
}

}  // namespace caustics
