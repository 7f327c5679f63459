#include "passes/cells/cells.hpp"

#include <algorithm>

namespace caustics {

extern const Shader cells_shader;

namespace {

CellsUniforms cells_uniforms(const PassContext& context) {
  const ViewUniforms receiver = pack(context.views->receiver);
  const ViewUniforms caustic = pack(context.views->caustic);
  const CellLimits limits;
  glm::vec4 tile{0.0f};
  if (const auto& cube = context.views->caustic.cube)
    tile = {cube->tile_width(), cube->tile_height(), 0.0f, 0.0f};
  glm::vec4 grid_tile{0.0f};
  if (const auto& cube = context.views->caster.cube) grid_tile = {cube->tile_width(), cube->guard, 0.0f, 0.0f};
  const int map = context.settings->map;
  return {
      .from_scene = caustic.from_scene,
      .receiver_window = receiver.window,
      .receiver_depth = receiver.depth,
      .caustic_window = caustic.window,
      .caustic_depth = caustic.depth,
      .limits = {limits.jump, limits.smallest_jump,
                 std::min(limits.largest_share * static_cast<float>(map), limits.largest), limits.gap},
      .tile = tile,
      .grid_tile = grid_tile,
      .grid = {context.settings->grid, map, 0, 0},
  };
}

}  // namespace

Pass cells_pass() {
  return {
      .definition =
          {
              .name = "cells",
              .purpose = "joins neighbouring landings to cells where one sheet of light spans them",
              .reads = {{.name = "landing", .meaning = "where each grid vertex's light lands"},
                        {.name = "landing_flux", .meaning = "how much of it is left"},
                        {.name = "caster_normal", .meaning = "which caster each grid vertex lies on"},
                        {.name = "receiver_position", .meaning = "what lies between the landings"}},
              .writes = {{.name = kCellNear,
                          .format = Format::RGBA32F,
                          .meaning = "places in the caustic map, texels, of the landings of grid vertices "
                                     "(x, y) in xy and (x + 1, y) in zw"},
                         {.name = kCellFar,
                          .format = Format::RGBA32F,
                          .meaning = "likewise of (x, y + 1) and (x + 1, y + 1)"},
                         {.name = kCellFlux,
                          .format = Format::RGBA32F,
                          .meaning = "rgb: flux of the cell, as landing_flux; w: 1 where the four are one "
                                     "cell, else 0"}},
              .shader = &cells_shader,
          },
      .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
        if (!effects.cells.active) return {};
        return "neighbouring landings are joined to cells";
      },
      .each = Each::Branch,
      .draws = DrawSet::FullScreen,
      .extent = Extent::Grid,
      .uniforms = [](const PassContext& context) { return uniform_bytes(cells_uniforms(context)); },
  };
}

}  // namespace caustics
