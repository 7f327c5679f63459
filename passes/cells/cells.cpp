#include "passes/cells/cells.hpp"

#include <algorithm>

#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader cells_shader;
extern const Shader cells_walked_shader;

namespace {

std140::Cells cells_uniforms(const PassContext& context) {
  const CellLimits limits;
  const CubeAtlas tiles = context.views->caustic.cube.value_or(CubeAtlas{});
  const CubeAtlas grid = context.views->caster.cube.value_or(CubeAtlas{});
  const int map = context.settings->map;
  return {
      .receiver = shader_view(context.views->receiver),
      .caustic = shader_view(context.views->caustic),
      .jump = limits.jump,
      .smallest_jump = limits.smallest_jump,
      .expected = limits.expected,
      .largest = std::min(limits.largest_share * static_cast<float>(map), limits.largest),
      .gap = limits.gap,
      .tile_width = static_cast<float>(tiles.tile_width()),
      .tile_height = static_cast<float>(tiles.tile_height()),
      .grid_tile = static_cast<float>(grid.tile_width()),
      .grid_guard = static_cast<float>(grid.guard),
      .grid_side = context.settings->grid,
      .map_side = map,
  };
}

}  // namespace

Pass cells_pass() {
  return {
      .name = "cells",
      .purpose = "joins neighbouring landings to cells where one sheet of light spans them",
      .reason = "neighbouring landings are joined to cells",
      .when = {&Effects::caustics, &Effects::cells},
      .drawn_for = {kBranch, kBranchFar},
      .only_lights_with_caustics = true,
      .size = grid_size,
      .reads = {{.name = "landing", .meaning = "where each grid vertex's light lands"},
                {.name = "landing_flux", .meaning = "how much of it is left"},
                {.name = "caster_normal", .meaning = "which caster each grid vertex lies on"},
                {.name = "receiver_position", .meaning = "what lies between the landings"},
                {.name = kLandingPath,
                 .meaning = "what each vertex's light has met",
                 .only_with = with<&Effects::further_surfaces>},
                {.name = kLandingFootprint,
                 .meaning = "where its neighbours are to be expected",
                 .only_with = with<&Effects::further_surfaces>}},
      .writes = {{.name = kCellNear,
                  .meaning = "places in the caustic map, texels, of the landings of grid vertices "
                             "(x, y) in xy and (x + 1, y) in zw"},
                 {.name = kCellFar, .meaning = "places likewise of (x, y + 1) and (x + 1, y + 1)"},
                 {.name = kCellFlux,
                  .meaning = "rgb: flux of the cell, as landing_flux; w: 1 where the four are one "
                             "cell, else 0"}},
      .shaders = {{&cells_shader, block_of<cells_uniforms>},
                  {&cells_walked_shader, block_of<cells_uniforms>, with<&Effects::further_surfaces>}},
  };
}

}  // namespace caustics
