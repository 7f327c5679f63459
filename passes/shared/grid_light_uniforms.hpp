// Fills the uniforms of a grid's light (grid_light_uniforms.glsl).
#pragma once
#include "passes/shared/light_uniforms.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

template <class Block>
void set_grid_light(Block& block, const PassContext& context) {
  const View& caster = context.views->caster;
  const CubeAtlas tiles = caster.cube.value_or(CubeAtlas{});
  const double side = context.settings->grid;
  block.caster = shader_view(caster);
  block.cone = shader_cone(*context.light);
  block.light = glm::vec3(caster.perspective ? context.light->position : caster.forward);
  block.cell_area = static_cast<float>(caster.window_area() / (side * side));
  block.tile_width = static_cast<float>(tiles.tile_width());
  block.tile_height = static_cast<float>(tiles.tile_height());
  block.tile_guard = static_cast<float>(tiles.guard);
  block.grid_side = context.settings->grid;
}

// What panes and blended surfaces leave of the light on its way to the grid vertices.
inline constexpr Read kReadReaching{
    .name = "reaching",
    .meaning = "rgb: what panes and blended surfaces before the casters leave of the light",
    .texture = "pane_transmittance.casters",
    .optional = true};
inline constexpr Choice kIsTinted{"is_tinted", chosen_by<&Effects::tinted_caustics>};

}  // namespace caustics
