#include "passes/stretches/stretches.hpp"

#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader stretches_shader;

namespace {

std140::Stretches stretches_uniforms(const PassContext& context) {
  return {walk_uniforms(context), shader_medium(*context.scene), vertices_per_beam(*context.settings)};
}

}  // namespace

Pass stretches_pass() {
  return {
      .name = "stretches",
      .purpose = "draws one stretch of each grid vertex's light through the medium, to stand for all of them",
      .reason = "light that is followed further is seen on its way",
      .when = {&Effects::light_shafts, &Effects::further_surfaces},
      .drawn_for = {kBranch},
      .only_lights_with_caustics = true,
      .size = grid_size,
      .reads = reads_of_walk(),
      .writes = {{.name = "stretch_start",
                  .meaning = "xyz: where the stretch starts, metres, scene space; w: its length, metres"},
                 {.name = "stretch_way",
                  .meaning = "xyz: its direction, unit; w: 1 where there is one, else 0"},
                 {.name = "stretch_flux",
                  .meaning =
                      "rgb: its flux at the start, as much more as the other stretches scatter, relative "
                      "to the light's intensity (square metres, or steradians)"}},
      .shaders = {{&stretches_shader, block_of<stretches_uniforms>}},
      .choices = choices_of_walk(),
  };
}

}  // namespace caustics
