#include "passes/caustic_cells/caustic_cells.hpp"

#include "passes/shared/caustic_map_write.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader caustic_cells_shader;

namespace {

std140::CausticCells caustic_cells_uniforms(const PassContext& context) {
  const View& map = context.views->caustic;
  const View& drawn = context.cascade() ? *context.views->cascade : map;
  const double texels = context.settings->map;
  const glm::dvec2 part = drawn.window_upper - drawn.window_lower;
  return {.scale = (map.window_upper - map.window_lower) / part,
          .offset = (map.window_lower - drawn.window_lower) / part * texels,
          .cells_a_side = context.settings->grid - 1,
          .map_side = context.settings->map};
}

}  // namespace

Pass caustic_cells_pass() {
  return {
      .name = "caustic_cells",
      .purpose = "adds up the light of the cells, by the exact share of each texel",
      .reason = "the cells' flux is gathered for the camera",
      .when = {&Effects::caustics, &Effects::cells},
      .drawn_for = {kBranch, kBranchFar, kBranchCascade},
      .only_lights_with_caustics = true,
      .draws = DrawSet::GridCells,
      .size = map_size,
      .reads = {{.name = kCellNear, .meaning = "each cell's lower corners in the map"},
                {.name = kCellFar, .meaning = "its upper corners"},
                {.name = kCellFlux, .meaning = "its flux"}},
      .writes = {caustic_map_write()},
      .owner = Each::Light,
      .topology = Topology::Rectangles,
      .zero_outside_quad = 0,
      .shaders = {{&caustic_cells_shader, block_of<caustic_cells_uniforms>}},
  };
}

}  // namespace caustics
