#include "passes/caster_flux/caster_flux.hpp"

#include "passes/shared/light_uniforms.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader caster_flux_shader;

namespace {

std140::CasterFlux caster_flux_uniforms(const PassContext& context) {
  const View& caster = context.views->caster;
  const CubeAtlas tiles = caster.cube.value_or(CubeAtlas{});
  return {
      .caster = shader_view(caster),
      .cone = shader_cone(*context.light),
      .light = glm::vec3(caster.perspective ? context.light->position : caster.forward),
      .cell_area = 1.0f,
      .tile_width = static_cast<float>(tiles.tile_width()),
      .tile_height = static_cast<float>(tiles.tile_height()),
      .tile_guard = static_cast<float>(tiles.guard),
      .grid_side = context.settings->grid,
  };
}

}  // namespace

Pass caster_flux_pass() {
  return {
      .name = "caster_flux",
      .purpose = "adds up the light on all grid vertices, and counts them",
      .reason = "each grid vertex has an equal part of the light",
      .when = {&Effects::caustics, &Effects::paper_weights},
      .drawn_for = {kLight},
      .only_lights_with_caustics = true,
      .draws = DrawSet::GridColumns,
      .size =
          [](const Settings&, const Effects&, const LightEffects*) {
            return TargetSize{1, 1};
          },
      .reads = {{.name = "caster_position", .meaning = "grid vertices"}},
      .writes = {{.name = "caster_flux",
                  .meaning =
                      "r: flux on the covered grid vertices, in that of a cell in the view's middle; g: "
                      "V, how many they are",
                  .blend = kAccumulate}},
      .topology = Topology::Points,
      .shaders = {{&caster_flux_shader, block_of<caster_flux_uniforms>}},
  };
}

}  // namespace caustics
