#include "passes/caustic_cells/caustic_cells.hpp"

namespace caustics {

extern const Shader caustic_cells_shader;

Pass caustic_cells_pass() {
  return {
      .definition =
          {
              .name = "caustic_cells",
              .purpose = "adds up the light of the cells, by the exact share of each texel",
              .reads = {{.name = kCellNear, .meaning = "each cell's lower corners in the map"},
                        {.name = kCellFar, .meaning = "its upper corners"},
                        {.name = kCellFlux, .meaning = "its flux"}},
              .writes = {{.name = kCausticMap,
                          .format = Format::RGBA32F,
                          .meaning = "rgb: flux in the texel, relative to the light's intensity (square "
                                     "metres, or steradians); a: number of cells and splats, by weight",
                          .blend = kAccumulate}},
              .topology = Topology::Points,
              .shader = &caustic_cells_shader,
          },
      .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
        if (!effects.active("cells")) return {};
        return "the cells' flux is gathered for the camera";
      },
      .each = Each::Branch,
      .draws = DrawSet::GridCells,
      .extent = Extent::Map,
      .uniforms =
          [](const PassContext& context) {
            return uniform_bytes(CausticCellsUniforms{
                .grid = {context.settings->grid - 1, context.settings->map, 0, 0}});
          },
      .owner = Each::Light,
  };
}

}  // namespace caustics
