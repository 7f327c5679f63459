#include "passes/glass/glass.hpp"

#include <glm/glm.hpp>

#include "passes/caster_map/caster_map.hpp"
#include "passes/shared/sky_uniforms.hpp"
#include "pipeline/effects/textured_casters.hpp"

namespace caustics {

extern const Shader caster_map_shader;
extern const Shader caster_exit_map_shader;
extern const Shader glass_shader;

namespace {

struct GlassUniforms {
  using vec4 = glm::vec4;
  using mat4 = glm::mat4;
  using ivec4 = glm::ivec4;
#include "passes/glass/glass_uniforms.glsl"
};

UniformBytes glass_uniforms(const PassContext& context) {
  const SkyUniforms sky = sky_uniforms(context.scene->environment);
  const bool tinted = context.effects->textured_casters.active;
  const ViewUniforms view = pack(*context.camera), wide = pack(*context.surroundings);
  return uniform_bytes(GlassUniforms{
      .sky_zenith = sky.zenith,
      .sky_horizon = sky.horizon,
      .sky_ground = sky.ground,
      .from_scene = view.from_scene,
      .window = view.window,
      .depth = view.depth,
      .wide_window = wide.window,
      .wide_depth = wide.depth,
      .eye = glm::vec4(glm::vec3(context.camera->origin), context.camera->perspective ? 1.0f : 0.0f),
      .forward = glm::vec4(glm::vec3(context.camera->forward), 0.0f),
      .method = {12, tinted ? 1 : 0, 0, 0},
  });
}

}  // namespace

Pass glass_pass() {
  return {
      .name = "glass",
      .purpose = "bends the view through refractive objects and mirrors it at their surface",
      .reason = "the camera may see a refractive object",
      .when = {&Effects::seen_casters},
      .reads = {{.name = "scene_color", .meaning = "the picture without glass"},
                {.name = "view_position", .meaning = "where its surfaces are"},
                {.name = "wide_color", .meaning = "the same over a wider view", .texture = "scene_color.surroundings"},
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
                 .optional = true}},
      .writes = {{.name = "beauty", .meaning = "rgb: radiance towards the camera, nit; a: 1"}},
      .shaders = {{&glass_shader}},
      .uniforms = glass_uniforms,
  };
}

}  // namespace caustics
