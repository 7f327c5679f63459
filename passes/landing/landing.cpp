#include "passes/landing/landing.hpp"

#include "passes/shared/grid_light_uniforms.hpp"
#include "passes/shared/medium_uniforms.hpp"
#include "passes/shared/receiver_search_uniforms.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader landing_shader;
extern const Shader landing_in_medium_shader;

namespace {

std140::Landing landing_uniforms(const PassContext& context) {
  std140::Landing block{};
  set_grid_light(block, context);
  set_receiver_search(block, context, kLandingTolerance);
  block.caustic = shader_view(context.views->caustic);
  block.channel_share = context.branch->color;
  block.bend = static_cast<float>(context.branch->bend);
  block.exit_tolerance = kExitTolerance;
  return block;
}

}  // namespace

Pass landing_pass() {
  return {
      .name = "landing",
      .purpose = "bends each grid vertex's light through the caster and finds where it lands",
      .reason = "each grid vertex's light is bent and followed to a receiver",
      .when = {&Effects::caustics},
      .unless = {&Effects::further_surfaces},
      .drawn_for = {kBranch, kBranchFar},
      .only_lights_with_caustics = true,
      .size = grid_size,
      .reads = {{.name = "caster_position", .meaning = "grid vertices"},
                {.name = "caster_normal", .meaning = "their normals and materials"},
                {.name = "caster_exit_position", .meaning = "the second surface", .optional = true},
                {.name = "caster_exit_normal", .meaning = "its normals", .optional = true},
                {.name = "receiver_position", .meaning = "what the light can land on"},
                {.name = "caster_materials",
                 .meaning = "row a material: index of refraction n_d, n_F - n_C, 1 for a mirror, -1 "
                            "for a rough wall; absorption per metre, 1 for a solid; base colour"},
                {.name = "caster_tint",
                 .meaning = "the grid vertices' colours, where textures give them",
                 .optional = true},
                {.name = "impostor_position",
                 .meaning = "what lies around the casters, for the estimator impostor",
                 .optional = true},
                {.name = "landed_before",
                 .meaning = "what has landed on the nearest receivers already, and is not followed again",
                 .texture = kLanding,
                 .only_for = kBranchFar.label},
                {.name = "caster_flux",
                 .meaning = "how much light all grid vertices have, and how many they are, for weights of "
                            "equal parts",
                 .optional = true},
                kReadReaching},
      .writes = {{.name = kLanding,
                  .meaning = "xyz: where the light lands, metres, scene space; w: LandingStatus"},
                 {.name = kLandingFlux,
                  .meaning = "rgb: flux that is left, relative to the light's intensity (square "
                             "metres, or steradians); w: gap left by the estimator, metres"},
                 {.name = kLandingFresnel,
                  .meaning = "rgb: flux reflected at the surfaces; w: flux that entered the cell"},
                 {.name = kLandingAbsorbed,
                  .meaning = "rgb: flux absorbed in the material; w: path inside, metres"},
                 {.name = kLandingMedium,
                  .meaning = "rgb: flux that the medium takes before the caster and after it",
                  .only_with = with<&Effects::medium>},
                 {.name = "stretch_start",
                  .meaning = "xyz: where the light leaves the caster, metres, scene space; w: how far "
                             "it goes from there through the medium, metres",
                  .only_with = with<&Effects::medium>},
                 {.name = "stretch_way",
                  .meaning = "xyz: its direction, unit; w: 1 where light leaves, else 0",
                  .only_with = with<&Effects::medium>},
                 {.name = "stretch_flux",
                  .meaning = "rgb: its flux where it leaves",
                  .only_with = with<&Effects::medium>}},
      .shaders = {{&landing_shader, block_of<landing_uniforms>},
                  {&landing_in_medium_shader, block_of<in_medium<landing_uniforms>>, with<&Effects::medium>}},
      .choices = {kNewtonGuard,
                  kDrawsUnconverged,
                  kEstimator,
                  {"paper_weights",
                   [](const PassContext& c) { return c.settings->weights == Weights::Paper ? 1 : 0; }},
                  {"is_reflection", [](const PassContext& c) { return c.branch->reflected ? 1 : 0; }},
                  {"has_mirrors", chosen_by<&Effects::mirrors>},
                  {"has_exit_maps", chosen_by<&Effects::exit_surface>},
                  {"wyman_thickness",
                   [](const PassContext& c) { return c.settings->thickness == Thickness::Wyman ? 1 : 0; }},
                  kIsTinted,
                  {"has_walls", chosen_by<&Effects::rough_glass>},
                  {"has_caster_tint", chosen_by<&Effects::textured_casters>},
                  {"only_unconverged", [](const PassContext& c) { return c.farthest() ? 1 : 0; }}},
  };
}

}  // namespace caustics
