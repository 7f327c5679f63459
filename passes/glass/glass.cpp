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

std::optional<std::string> seen(const Effects& effects) {
  if (!effects.seen_casters.active) return {};
  return "the camera may see a refractive object";
}

UniformBytes caster_uniforms(const PassContext& context) {
  return uniform_bytes(caster_map_uniforms(*context.camera, context.material_row));
}

}  // namespace

Pass view_caster_map_pass() {
  return {.definition =
              {.name = "view_caster_map",
               .purpose = "finds the refractive surface nearest to the camera",
               .writes = {{.name = "view_caster_position",
                           .meaning = "xyz: position, metres, scene space; w: 1 a front face, -1 a back "
                                      "face, 0 none"},
                          {.name = "view_caster_normal",
                           .meaning = "xyz: unit shading normal, outward; w: row of the material in "
                                      "caster_materials"}},
               .depth = DepthWrite{.name = "view_caster_depth", .meaning = "window depth"},
               .depth_state = {.compare = Compare::Less, .write = true},
               .shader = &caster_map_shader},
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            if (caster_detail(effects) != CasterDetail::None) return {};
            return seen(effects);
          },
          .draws = DrawSet::Casters,
          .extent = Extent::Picture,
          .uniforms = caster_uniforms};
}

Pass view_exit_map_pass() {
  return {.definition =
              {.name = "view_exit_map",
               .purpose = "finds the back faces of solid refractive objects, seen from the camera",
               .writes = {{.name = "view_exit_position",
                           .meaning = "xyz: position, metres, scene space; w: 1 where there is one"},
                          {.name = "view_exit_normal",
                           .meaning = "xyz: unit shading normal, outward; w: 1 where there is one"}},
               .depth = DepthWrite{.name = "view_exit_depth", .meaning = "window depth"},
               .depth_state = {.compare = Compare::Less, .write = true},
               .cull = Cull::Front,
               .shader = &caster_exit_map_shader},
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            if (!effects.exit_surface.active || detailed_exits(effects)) return {};
            return seen(effects);
          },
          .draws = DrawSet::SolidCasters,
          .extent = Extent::Picture,
          .uniforms = caster_uniforms};
}

Pass glass_pass() {
  return {.definition =
              {.name = "glass",
               .purpose = "bends the view through refractive objects and mirrors it at their surface",
               .reads = {{.name = "scene_color", .meaning = "the picture without glass"},
                         {.name = "view_position", .meaning = "where its surfaces are"},
                         {.name = "wide_color", .meaning = "the same over a wider view"},
                         {.name = "wide_position", .meaning = "where its surfaces are"},
                         {.name = "view_caster_position", .meaning = "the glass"},
                         {.name = "view_caster_normal", .meaning = "its normals and materials"},
                         {.name = "view_exit_position",
                          .meaning = "its back faces",
                          .optional = true},
                         {.name = "view_exit_normal",
                          .meaning = "their normals",
                          .optional = true},
                         {.name = kCasterMaterials, .meaning = "indices, absorption, tint"},
                         {.name = kEnvironment,
                          .meaning = "radiance from all around",
                          .optional = true},
                         {.name = "view_caster_tint",
                          .meaning = "the glass's colour, where textures give it",
                          .optional = true}},
               .writes = {{.name = "beauty",
                           .meaning = "rgb: radiance towards the camera, nit; a: 1"}},
               .shader = &glass_shader},
          .called_for_by = seen,
          .extent = Extent::Picture,
          .uniforms = glass_uniforms};
}

}  // namespace caustics
