#include "passes/glass/glass.hpp"

#include "passes/shared/layer_reads.hpp"
#include "passes/shared/receiver_search_uniforms.hpp"
#include "passes/shared/sight_uniforms.hpp"

namespace caustics {

extern const Shader glass_shader;

namespace {

// Fewer than kMostStepsOfSight where a pixel has four times as many rays.
constexpr int kMostStepsOfSeveral = 640;
// As many as 16 samples have, where fewer were asked for.
int several_rays(const PassContext& context) {
  const int samples = samples_a_pixel(*context.settings);
  return samples > 1 && samples < 16 ? 1 : 0;
}

std140::Glass glass_uniforms(const PassContext& context) {
  std140::Glass block{};
  block.sky = shader_sky(context.scene->environment);
  set_sight(block, context);
  if (several_rays(context) != 0) block.most_steps = kMostStepsOfSeveral;
  const Bounds receivers = receivers_box(context);
  block.receivers_lower = glm::vec3(receivers.lower);
  block.receivers_upper = glm::vec3(receivers.upper);
  return block;
}

}  // namespace

Pass glass_pass() {
  return {
      .name = "glass",
      .purpose = "follows the view through refractive and mirroring objects from surface to surface",
      .reason = "the camera may see refractive or mirroring objects",
      .when = {&Effects::seen_casters},
      .reads = {{.name = "scene_color", .meaning = "the picture without glass"},
                {.name = "picture_position", .meaning = "where its surfaces are", .texture = "view_position"},
                {.name = "behind_color",
                 .meaning = "what only glass shows, behind it",
                 .texture = "scene_color.behind"},
                {.name = "mirrored_color",
                 .meaning = "what only glass and metal show, mirrored",
                 .texture = "scene_color.in_mirrors"},
                kReadSeenCasters,
                kReadSeenNormals,
                {.name = kCasterMaterials, .meaning = "indices, absorption, tint"},
                kReadHierarchyNodes,
                kReadHierarchyTriangles,
                kReadHierarchyNormals,
                {.name = kEnvironment, .meaning = "radiance from all around", .optional = true},
                {.name = "caster_highlight",
                 .meaning = "what the first glass and metal mirror of the lights, nit",
                 .optional = true,
                 .needed_with = &Effects::highlights},
                {.name = "highlight_through_panes",
                 .meaning = "the same of those behind panes",
                 .texture = "caster_highlight.through_panes",
                 .optional = true,
                 .needed_with = &Effects::highlights},
                kReadLayers,
                kReadFirstLayer,
                kReadCasterTexels},
      .writes = {{.name = "beauty", .meaning = "rgb: radiance towards the camera, nit; a: 1"}},
      .shaders = {{&glass_shader, block_of<glass_uniforms>}},
      .choices = {{"blends", chosen_by<&Effects::layered>},
                  {"several_rays", several_rays},
                  kSightHasTextures,
                  kSightHasRough,
                  kHasWalls,
                  kSightHasSheets},
  };
}

}  // namespace caustics
