#include "passes/caustic_cells/caustic_cells.hpp"

#include "passes/shared/caustic_map_write.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader caustic_cells_shader;

Pass caustic_cells_pass() {
  return {
      .name = "caustic_cells",
      .purpose = "adds up the light of the cells, by the exact share of each texel",
      .reason = "the cells' flux is gathered for the camera",
      .when = {&Effects::caustics, &Effects::cells},
      .drawn_for = {kBranch, kBranchFar},
      .only_lights_with_caustics = true,
      .draws = DrawSet::GridCells,
      .size = map_size,
      .reads = {{.name = kCellNear, .meaning = "each cell's lower corners in the map"},
                {.name = kCellFar, .meaning = "its upper corners"},
                {.name = kCellFlux, .meaning = "its flux"}},
      .writes = {caustic_map_write()},
      .owner = Each::Light,
      .topology = Topology::Points,
      .shaders = {{&caustic_cells_shader, block_of<[](const PassContext& c) {
                     return std140::CausticCells{.cells_a_side = c.settings->grid - 1,
                                                 .map_side = c.settings->map};
                   }>}},
  };
}

}  // namespace caustics
