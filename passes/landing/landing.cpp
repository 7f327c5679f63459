#include "passes/landing/landing.hpp"

#include "passes/shared/light_uniforms.hpp"
#include "pipeline/plan/all_around.hpp"

namespace caustics {

extern const Shader landing_shader;

namespace {

LandingUniforms landing_uniforms(const PassContext& context) {
  const LightFrames& frames = *context.frames;
  const Settings& settings = *context.settings;
  const Branch& branch = *context.branch;
  const FrameUniforms caster = pack(frames.caster);
  const FrameUniforms receiver = pack(frames.receiver);
  const FrameUniforms caustic = pack(frames.caustic);
  const bool around = settings.estimator == Estimator::Impostor && context.effects->active("distance impostors");
  const FrameUniforms impostors =
      around ? pack(with_atlas(context.effects->impostors, settings.map)) : FrameUniforms{};
  glm::vec4 tile{0.0f};
  if (const auto& cube = frames.caster.cube)
    tile = {cube->tile_width(), cube->tile_height(), cube->guard, 1.0f};
  const LightCone cone = light_cone(*context.light);
  const double cells = static_cast<double>(settings.grid) * static_cast<double>(settings.grid);
  return {
      .from_scene = caster.from_scene,
      .caster_window = caster.window,
      .caster_depth = caster.depth,
      .receiver_window = receiver.window,
      .receiver_depth = receiver.depth,
      .caustic_window = caustic.window,
      .caustic_depth = caustic.depth,
      .light = glm::vec4(glm::vec3(frames.caster.perspective ? context.light->position
                                                             : frames.caster.forward),
                         0.0f),
      .cone_axis = cone.axis,
      .cone = cone.scale_offset,
      .cell = {static_cast<float>(frames.caster.window_area() / cells), kExitTolerance,
               kLandingTolerance, context.effects->active("mirrors") ? 1.0f : 0.0f},
      .tile = tile,
      .branch = glm::vec4(branch.color, static_cast<float>(branch.bend)),
      .impostor_from_scene = impostors.from_scene,
      .impostor_window = impostors.window,
      .impostor_depth = impostors.depth,
      .impostor_centre = glm::vec4(glm::vec3(context.effects->impostors.origin), 0.0f),
      .method = {settings.iterations, static_cast<int>(settings.estimator),
                 settings.weights == Weights::Paper ? 1 : 0,
                 context.effects->active("exit surface") ? 1 : 0},
      .variant = {branch.reflected ? 1 : 0, settings.thickness == Thickness::Wyman ? 1 : 0, 0, 0},
  };
}

}  // namespace

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
                        {.name = "impostor_position",
                         .meaning = "what lies around the casters, for the estimator impostor",
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
        if (!effects.active("caustics")) return {};
        return "each grid vertex's light is bent and followed to a receiver";
      },
      .each = Each::Branch,
      .draws = DrawSet::FullScreen,
      .extent = Extent::Grid,
      .uniforms = [](const PassContext& context) { return uniform_bytes(landing_uniforms(context)); },
  };
}

}  // namespace caustics
