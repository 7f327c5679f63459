#include "passes/cascade_cells/cascade_cells.hpp"

#include "passes/caustic_map/caustic_map.hpp"
#include "passes/shared/caustic_map_write.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader cascade_cells_shader;

namespace {

std140::CascadeCells cells_uniforms(const PassContext& context) {
  const View& map = context.views->caustic;
  const View& cascade = *context.views->cascade;
  const double texels = context.settings->map;
  const glm::dvec2 size = map.window_upper - map.window_lower;
  const glm::dvec2 part = cascade.window_upper - cascade.window_lower;
  const glm::dvec2 offset = (map.window_lower - cascade.window_lower) / part * texels;
  return {.scale = size / part,
          .offset = offset,
          .cells_a_side = context.settings->grid - 1,
          .map_side = context.settings->map};
}

}  // namespace

Pass cascade_cells_pass() {
  return {
      .name = "cascade_cells",
      .purpose = "adds up the light of the cells once more, where it is dense, in finer texels",
      .reason = "most of the light falls on little of its map",
      .when = {&Effects::caustics, &Effects::cells},
      .drawn_for = {kBranchCascade},
      .only_lights_with_caustics = true,
      .draws = DrawSet::GridCellQuads,
      .size = map_size,
      .reads = {{.name = kCellNear, .meaning = "each cell's lower corners in the caustic map"},
                {.name = kCellFar, .meaning = "its upper corners"},
                {.name = kCellFlux, .meaning = "its flux"}},
      .writes = {caustic_map_write()},
      .owner = Each::Light,
      .shaders = {{&cascade_cells_shader, block_of<cells_uniforms>}},
  };
}

}  // namespace caustics
