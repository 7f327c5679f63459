#include "passes/caster_flux/caster_flux.hpp"

#include "passes/shared/grid_light_uniforms.hpp"

namespace caustics {

extern const Shader caster_flux_shader;

namespace {

// Flux is counted in that of a cell in the view's middle.
std140::CasterFlux caster_flux_uniforms(const PassContext& context) {
  std140::CasterFlux block{};
  set_grid_light(block, context);
  block.cell_area = 1.0f;
  return block;
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
