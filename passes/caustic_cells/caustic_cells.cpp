#include "passes/caustic_cells/caustic_cells.hpp"

#include "passes/shared/caustic_map_write.hpp"

namespace caustics {

extern const Shader caustic_cells_shader;

namespace {

// The flux is gathered where there is any, in as many channels as it has.
std::optional<std::string> called_for(const Effects& effects, bool coloured) {
  if (!effects.cells.active || effects.coloured_caustics.active != coloured) return {};
  return "the cells' flux is gathered for the camera";
}
std::optional<std::string> called_for_coloured(const Effects& e) { return called_for(e, true); }
std::optional<std::string> called_for_grey(const Effects& e) { return called_for(e, false); }

Pass caustic_cells_pass(bool coloured) {
  return {
      .definition =
          {
              .name = coloured ? "caustic_cells" : "caustic_cells_grey",
              .purpose = "adds up the light of the cells, by the exact share of each texel",
              .reads = {{.name = kCellNear, .meaning = "each cell's lower corners in the map"},
                        {.name = kCellFar, .meaning = "its upper corners"},
                        {.name = kCellFlux, .meaning = "its flux"}},
              .writes = {caustic_map_write(coloured)},
              .topology = Topology::Points,
              .shader = &caustic_cells_shader,
          },
      .called_for_by = coloured ? called_for_coloured : called_for_grey,
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

}  // namespace

Pass caustic_cells_pass() { return caustic_cells_pass(true); }
Pass caustic_cells_grey_pass() { return caustic_cells_pass(false); }

}  // namespace caustics
