#include "passes/walked_glass/walked_glass.hpp"

#include <algorithm>

#include "passes/shared/hierarchy_reads.hpp"
#include "passes/shared/layer_reads.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader walked_glass_shader;

namespace {

// Steps to each surface, all together fewer than the rounds that llvmpipe grants an invocation's loops;
// surfaces behind the first that bend a ray, as what total reflection sends through more is a different place
// for each pixel; and those that it passes then.
constexpr int kMostStepsInGlass = 2048, kMostBends = 6, kMostPassed = 4;
// The same where a pixel has four times as many rays.
constexpr int kMostStepsOfSeveral = 640;
// As many as 16 samples have, where fewer were asked for.
int several_rays(const PassContext& context) {
  const int samples = samples_a_pixel(*context.settings);
  return samples > 1 && samples < 16 ? 1 : 0;
}

std140::WalkedGlass walked_glass_uniforms(const PassContext& context) {
  const int bends = std::min(context.settings->bounces, kMostBends);
  return {
      .sky = shader_sky(context.scene->environment),
      .view = shader_view(*context.camera),
      .surroundings = shader_view(*context.surroundings),
      .eye = context.camera->origin,
      .surfaces = bends,
      .most_surfaces = bends + kMostPassed,
      .forward = context.camera->forward,
      .bend = 0.0f,
      .most_steps = several_rays(context) != 0 ? kMostStepsOfSeveral : kMostStepsInGlass,
      .first_receiver = context.first_receiver,
      .touch = context.touch,
      .first_uv = context.first_uv,
  };
}

}  // namespace

Pass walked_glass_pass() {
  return {
      .name = "walked_glass",
      .purpose = "follows the view through refractive and mirroring objects from surface to surface",
      .reason = "the camera may see what lies behind more than two surfaces",
      .when = {&Effects::seen_casters, &Effects::followed_view},
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
                {.name = "view_caster_triangle",
                 .meaning = "its triangles",
                 .texture = "caster_triangle.camera"},
                {.name = kCasterMaterials, .meaning = "indices, absorption, tint"},
                kReadHierarchyNodes,
                kReadHierarchyTriangles,
                kReadHierarchyNormals,
                {.name = kEnvironment, .meaning = "radiance from all around", .optional = true},
                {.name = "caster_highlight",
                 .meaning = "what the first glass and metal mirror of the lights, nit",
                 .optional = true,
                 .needed_with = &Effects::highlights},
                kReadLayers,
                kReadFirstLayer,
                kReadCasterTexels},
      .writes = {{.name = "beauty", .meaning = "rgb: radiance towards the camera, nit; a: 1"}},
      .shaders = {{&walked_glass_shader, block_of<walked_glass_uniforms>}},
      .choices = {{"blends", chosen_by<&Effects::layered>}, {"several_rays", several_rays}, kHasTextures},
  };
}

}  // namespace caustics
