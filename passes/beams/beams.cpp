#include "passes/beams/beams.hpp"

#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader beams_shader;

int goes_own_ways(const PassContext& context) {
  const Effects& effects = *context.effects;
  const bool facets = effects.rough_glass.active && effects.further_surfaces.active;
  const bool points = context.of_light && context.of_light->size_is_drawn;
  return context.branch->drawn || facets || points ? 1 : 0;
}

Pass beams_pass() {
  return {
      .name = "beams",
      .purpose = "joins neighbouring grid vertices' light to beams that are seen in the medium",
      .reason = "the casters' light is seen as beams",
      .when = {&Effects::light_shafts},
      .drawn_for = {kBranch},
      .only_lights_with_caustics = true,
      .size = beams_size,
      .reads = {{.name = "stretch_start", .meaning = "where light leaves the caster, and how far it goes"},
                {.name = "stretch_way", .meaning = "its direction"},
                {.name = "stretch_flux", .meaning = "its flux there"}},
      .writes = {{.name = "beam_start",
                  .meaning = "xyz: where the beam starts, metres, scene space; w: its length, metres"},
                 {.name = "beam_way", .meaning = "xyz: its unit direction; w: 1 where there is one, else 0"},
                 {.name = "beam_flux",
                  .meaning = "rgb: its flux at the start, relative to the light's intensity (square metres, "
                             "or steradians)"}},
      .shaders = {{&beams_shader, block_of<[](const PassContext& c) {
                     return std140::Beams{.grid_side = c.settings->grid,
                                          .vertices_per_beam = vertices_per_beam(*c.settings)};
                   }>}},
      .choices = {{"draws", goes_own_ways}},
  };
}

}  // namespace caustics
