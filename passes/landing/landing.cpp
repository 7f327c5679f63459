#include "passes/landing/landing.hpp"

#include <algorithm>

#include "passes/medium/medium_uniforms.hpp"
#include "passes/shared/light_uniforms.hpp"
#include "pipeline/scene/cube_view.hpp"

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

}  // namespace

LandingUniforms landing_uniforms(const PassContext& context) {
  const LightViews& views = *context.views;
  const Settings& settings = *context.settings;
  const Branch& branch = *context.branch;
  const ViewUniforms caster = pack(views.caster);
  const ViewUniforms receiver = pack(views.receiver);
  const ViewUniforms caustic = pack(views.caustic);
  const bool around = settings.estimator == Estimator::Impostor && context.effects->distance_impostors.active;
  const ViewUniforms impostors =
      around ? pack(with_atlas(context.effects->impostors, settings.map)) : ViewUniforms{};
  glm::vec4 tile{0.0f};
  if (const auto& cube = views.caster.cube)
    tile = {cube->tile_width(), cube->tile_height(), cube->guard, 1.0f};
  const LightCone cone = light_cone(*context.light);
  const Bounds receivers = receivers_box(context);
  const double cells = static_cast<double>(settings.grid) * static_cast<double>(settings.grid);
  return {
      .from_scene = caster.from_scene,
      .caster_window = caster.window,
      .caster_depth = caster.depth,
      .receiver_window = receiver.window,
      .receiver_depth = receiver.depth,
      .caustic_window = caustic.window,
      .caustic_depth = caustic.depth,
      .light = glm::vec4(glm::vec3(views.caster.perspective ? context.light->position
                                                             : views.caster.forward),
                         0.0f),
      .cone_axis = cone.axis,
      .cone = cone.scale_offset,
      .cell = {static_cast<float>(views.caster.window_area() / cells), kExitTolerance,
               kLandingTolerance, context.effects->mirrors.active ? 1.0f : 0.0f},
      .receivers_lower = glm::vec4(receivers.lower, 0.0),
      .receivers_upper = glm::vec4(receivers.upper, 0.0),
      .tile = tile,
      .branch = glm::vec4(branch.color, static_cast<float>(branch.bend)),
      .impostor_from_scene = impostors.from_scene,
      .impostor_window = impostors.window,
      .impostor_depth = impostors.depth,
      .impostor_centre = glm::vec4(glm::vec3(context.effects->impostors.origin), 0.0f),
      .method = {settings.iterations, static_cast<int>(settings.estimator),
                 settings.weights == Weights::Paper ? 1 : 0,
                 context.effects->exit_surface.active ? 1 : 0},
      .variant = {branch.reflected ? 1 : 0, settings.thickness == Thickness::Wyman ? 1 : 0,
                  context.effects->textured_casters.active ? 1 : 0, 0},
  };
}

Pass landing_pass() {
  return {
      .definition =
          {
              .name = "landing",
              .purpose = "bends each grid vertex's light through the caster and finds where it lands",
              .reads = {{.name = "caster_position", .meaning = "grid vertices"},
                        {.name = "caster_normal", .meaning = "their normals and materials"},
                        {.name = "caster_exit_position",
                         .meaning = "the second surface",
                         .optional = true},
                        {.name = "caster_exit_normal",
                         .meaning = "its normals",
                         .optional = true},
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
                        {.name = kLandedBefore,
                         .meaning = "the status after an earlier search, which this one goes on from",
                         .optional = true}},
              .writes = {{.name = "landing",
                          .format = Format::RGBA32F,
                          .meaning = "xyz: where the light lands, metres, scene space; w: LandingStatus"},
                         {.name = "landing_flux",
                          .format = Format::RGBA32F,
                          .meaning = "rgb: flux that is left, relative to the light's intensity (square "
                                     "metres, or steradians); w: gap left by the estimator, metres"},
                         {.name = "landing_fresnel",
                          .format = Format::RGBA32F,
                          .meaning = "rgb: flux reflected at the surfaces; w: flux that entered the cell"},
                         {.name = "landing_absorbed",
                          .format = Format::RGBA32F,
                          .meaning = "rgb: flux absorbed in the material; w: path inside, metres"}},
              .shader = &landing_shader,
          },
      .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
        if (!effects.caustics.active || effects.medium.active) return {};
        return "each grid vertex's light is bent and followed to a receiver";
      },
      .each = Each::Branch,
      .draws = DrawSet::FullScreen,
      .extent = Extent::Grid,
      .uniforms = [](const PassContext& context) { return uniform_bytes(landing_uniforms(context)); },
  };
}

Pass landing_in_medium_pass() {
  Pass pass = landing_pass();
  PassDefinition& definition = pass.definition;
  definition.name = "landing_in_medium";
  definition.purpose += ", through a medium";
  definition.shader = &landing_in_medium_shader;
  definition.writes.push_back({.name = kLandingMedium,
                               .meaning = "rgb: flux that the medium takes before the caster and after it"});
  definition.writes.push_back({.name = "landing_start",
                               .meaning = "xyz: where the light leaves the caster, metres, scene space; w: how far "
                                          "it goes from there through the medium, metres"});
  definition.writes.push_back({.name = "landing_way",
                               .meaning = "xyz: its direction, unit; w: 1 where light leaves, else 0"});
  definition.writes.push_back({.name = "landing_start_flux", .meaning = "rgb: its flux where it leaves"});
  pass.called_for_by = [](const Effects& effects) -> std::optional<std::string> {
    if (!effects.caustics.active || !effects.medium.active) return {};
    return "each grid vertex's light is bent and followed through the medium to a receiver";
  };
  pass.uniforms = [](const PassContext& context) {
    return with_medium(uniform_bytes(landing_uniforms(context)), *context.scene);
  };
  return pass;
}

}  // namespace caustics
