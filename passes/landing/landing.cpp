#include "passes/landing/landing.hpp"

#include <algorithm>

#include "passes/shared/medium_uniforms.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader landing_shader;
extern const Shader landing_in_medium_shader;

namespace {

// The box around all receivers, a little larger for the rounding of rays; a point where there are none.
Bounds receivers_box(const PassContext& context) {
  Bounds box;
  const std::vector<SurfaceRole>& surfaces = context.effects->surfaces;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].role == Role::Receiver) box.add(bounds_of(context.scene->meshes[i]));
  if (box.empty()) return {glm::dvec3(0.0), glm::dvec3(0.0)};
  const glm::dvec3 slack(1e-4 * std::max(box.radius(), 1e-9));
  return {box.lower - slack, box.upper + slack};
}

std140::Landing landing_uniforms(const PassContext& context) {
  const LightViews& views = *context.views;
  const Settings& settings = *context.settings;
  const Branch& branch = *context.branch;
  const bool impostors =
      settings.estimator == Estimator::Impostor && context.effects->distance_impostors.active;
  const CubeAtlas tiles = views.caster.cube.value_or(CubeAtlas{});
  const Bounds receivers = receivers_box(context);
  const double cells = static_cast<double>(settings.grid) * static_cast<double>(settings.grid);
  return {
      .caster = shader_view(views.caster),
      .receiver = shader_view(views.receiver),
      .caustic = shader_view(views.caustic),
      .cone = shader_cone(*context.light),
      .light = glm::vec3(views.caster.perspective ? context.light->position : views.caster.forward),
      .cell_area = static_cast<float>(views.caster.window_area() / cells),
      .channel_share = branch.color,
      .bend = static_cast<float>(branch.bend),
      .receivers_lower = receivers.lower,
      .exit_tolerance = kExitTolerance,
      .receivers_upper = receivers.upper,
      .landing_tolerance = kLandingTolerance,
      .impostor_centre = context.effects->impostors.origin,
      .tile_width = static_cast<float>(tiles.tile_width()),
      .tile_height = static_cast<float>(tiles.tile_height()),
      .tile_guard = static_cast<float>(tiles.guard),
      .iterations = settings.iterations,
      .search_start = settings.search_start.value_or(settings.estimator == Estimator::Newton ? 0.1f : 0.0f),
      .newton_epsilon = settings.newton_epsilon.value_or(0.0f),
      .impostor =
          impostors ? shader_view(with_atlas(context.effects->impostors, settings.map)) : std140::View{},
  };
}

}  // namespace

Pass landing_pass() {
  return {
      .name = "landing",
      .purpose = "bends each grid vertex's light through the caster and finds where it lands",
      .reason = "each grid vertex's light is bent and followed to a receiver",
      .when = {&Effects::caustics},
      .drawn_for = {kBranch, kBranchFar},
      .only_lights_with_caustics = true,
      .size = grid_size,
      .reads = {{.name = "caster_position", .meaning = "grid vertices"},
                {.name = "caster_normal", .meaning = "their normals and materials"},
                {.name = "caster_exit_position", .meaning = "the second surface", .optional = true},
                {.name = "caster_exit_normal", .meaning = "its normals", .optional = true},
                {.name = "receiver_position", .meaning = "what the light can land on"},
                {.name = "caster_materials",
                 .meaning = "row a material: index of refraction n_d, n_F - n_C, 1 for a mirror; "
                            "absorption per metre, 1 for a solid; base colour"},
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
                 .optional = true}},
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
                 {.name = "landing_start",
                  .meaning = "xyz: where the light leaves the caster, metres, scene space; w: how far "
                             "it goes from there through the medium, metres",
                  .only_with = with<&Effects::medium>},
                 {.name = "landing_way",
                  .meaning = "xyz: its direction, unit; w: 1 where light leaves, else 0",
                  .only_with = with<&Effects::medium>},
                 {.name = "landing_start_flux",
                  .meaning = "rgb: its flux where it leaves",
                  .only_with = with<&Effects::medium>}},
      .shaders = {{&landing_shader, block_of<landing_uniforms>},
                  {&landing_in_medium_shader, block_of<in_medium<landing_uniforms>>, with<&Effects::medium>}},
      .choices = {{"estimator", [](const PassContext& c) { return static_cast<int>(c.settings->estimator); }},
                  {"paper_weights",
                   [](const PassContext& c) { return c.settings->weights == Weights::Paper ? 1 : 0; }},
                  {"newton_guard", [](const PassContext& c) { return c.settings->newton_guard ? 1 : 0; }},
                  {"draws_unconverged",
                   [](const PassContext& c) { return c.settings->draw_unconverged ? 1 : 0; }},
                  {"is_reflection", [](const PassContext& c) { return c.branch->reflected ? 1 : 0; }},
                  {"has_mirrors", chosen_by<&Effects::mirrors>},
                  {"has_exit_maps", chosen_by<&Effects::exit_surface>},
                  {"wyman_thickness",
                   [](const PassContext& c) { return c.settings->thickness == Thickness::Wyman ? 1 : 0; }},
                  {"has_caster_tint", chosen_by<&Effects::textured_casters>},
                  {"only_unconverged", [](const PassContext& c) { return c.farthest() ? 1 : 0; }}},
  };
}

}  // namespace caustics
