#include "passes/hidden_landings/hidden_landings.hpp"

namespace caustics {

extern const Shader hidden_landings_shader;

namespace {

std140::HiddenLandings hidden_landings_uniforms(const PassContext& context) {
  return {.receiver = shader_view(context.views->receiver)};
}

}  // namespace

Pass hidden_landings_pass() {
  return {
      .name = "hidden_landings",
      .purpose = "takes what has landed where the light does not see, for the light's second caustic map",
      .reason = kHidden,
      .when = {&Effects::caustics, &Effects::further_surfaces},
      .drawn_for = {kBranchFar},
      .only_lights_with_caustics = true,
      .size = grid_size,
      .reads = {{.name = "landed_before",
                 .meaning = "what has landed, and where",
                 .texture = kLanding,
                 .discards_where_zero = true},
                {.name = "flux_before", .meaning = "its flux", .texture = kLandingFlux},
                {.name = "fresnel_before", .meaning = "and what is booked of it", .texture = kLandingFresnel},
                {.name = "absorbed_before", .meaning = "likewise", .texture = kLandingAbsorbed},
                {.name = "path_before", .meaning = "what it has met", .texture = kLandingPath},
                {.name = "footprint_before", .meaning = "how wide it is", .texture = kLandingFootprint},
                {.name = "receiver_position", .meaning = "the farthest receivers"}},
      .writes = {{.name = kLanding,
                  .meaning = "xyz: where the light lands, metres, scene space; w: LandingStatus"},
                 {.name = kLandingFlux, .meaning = "rgb: flux that is left, as walk has it"},
                 {.name = kLandingFresnel, .meaning = "rgb: flux reflected at the surfaces, likewise"},
                 {.name = kLandingAbsorbed, .meaning = "rgb: flux absorbed in the material"},
                 {.name = kLandingPath, .meaning = "as walk has it"},
                 {.name = kLandingFootprint, .meaning = "likewise"}},
      .shaders = {{&hidden_landings_shader, block_of<hidden_landings_uniforms>}},
  };
}

}  // namespace caustics
