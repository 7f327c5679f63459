#include "passes/next_surface/next_surface.hpp"

#include "passes/shared/hierarchy_reads.hpp"

namespace caustics {

extern const Shader next_surface_shader;

namespace {

// llvmpipe ends an invocation's loops after 65,535 rounds, all counted.
constexpr int kMostSteps = 16384;

std140::NextSurface next_surface_uniforms(const PassContext& context) {
  return {.most_steps = kMostSteps, .first_receiver = context.first_receiver, .touch = context.touch};
}

}  // namespace

Pass next_surface_pass() {
  return {
      .name = "next_surface",
      .purpose = "finds the next triangle that each ray under way meets",
      .reason = "light goes other ways than through two surfaces",
      .when = {&Effects::caustics, &Effects::further_surfaces},
      .drawn_for = {kSurfaceAhead},
      .only_lights_with_caustics = true,
      .size = grid_size,
      .reads = {path_read("path_start", "ray_start"), path_read("path_direction", "ray_direction"),
                path_read("path_media", "ray_media"), kReadHierarchyNodes, kReadHierarchyTriangles,
                kReadHierarchyNormals},
      .writes = {{.name = "surface_hit",
                  .meaning = "xy: weights of the triangle's second and third corner; z: metres to it; w: its "
                             "number plus 1, 0 where nothing is met, -1 where the walk took too many steps"}},
      .shaders = {{&next_surface_shader, block_of<next_surface_uniforms>}},
  };
}

}  // namespace caustics
