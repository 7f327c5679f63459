#include "passes/ambient_rays/ambient_rays.hpp"

#include "passes/shared/hierarchy_reads.hpp"

namespace caustics {

extern const Shader ambient_rays_shader;

namespace {

// So few that a ray along a thousand blades of grass does not hold up its neighbours: it counts as open.
constexpr int kMostAmbientSteps = 1024;

std140::AmbientRays ambient_rays_uniforms(const PassContext& context) {
  return {.most_steps = kMostAmbientSteps,
          .first_receiver = context.first_receiver,
          .touch = context.touch,
          .reach = context.scene->environment.reach};
}

}  // namespace

Pass ambient_rays_pass() {
  return {
      .name = "ambient_rays",
      .purpose = "asks by a few rays how much of the environment's light arrives at surfaces",
      .reason = "surfaces keep the environment's light from others near by",
      .when = {&Effects::ambient_occlusion},
      .coarser = kAmbientPixels,
      .reads = {{.name = "view_position", .meaning = "the surfaces"},
                {.name = "view_normal", .meaning = "their normals"},
                {.name = kCasterMaterials, .meaning = "what glass lets through"},
                kReadHierarchyNodes,
                kReadHierarchyTriangles,
                kReadHierarchyNormals},
      .writes = {{.name = "ambient_rays",
                  .meaning = "xyz: the point, metres, scene space; w: 1 and the share of its rays that are "
                             "open, 0 where there is no surface"}},
      .shaders = {{&ambient_rays_shader, block_of<ambient_rays_uniforms>}},
  };
}

}  // namespace caustics
