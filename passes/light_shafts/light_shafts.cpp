#include "passes/light_shafts/light_shafts.hpp"

#include <algorithm>

#include "passes/beams/beams.hpp"
#include "passes/shared/light_uniforms.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader light_shafts_shader;

namespace {

// Beams are drawn no wider than this share of the picture's larger side.
constexpr float kWidest = 0.0625f;
// And those that have no neighbours, for which a beam is one of many that lie across each other.
constexpr float kWidestAlone = kWidest / 4.0f;

std140::LightShafts light_shafts_uniforms(const PassContext& context) {
  const float width = static_cast<float>(context.width), height = static_cast<float>(context.height);
  const float widest = goes_own_ways(context) != 0 ? kWidestAlone : kWidest;
  const double pixels = static_cast<double>(context.width) * static_cast<double>(context.height);
  return {.view = shader_view(*context.camera),
          .picture = {width, height},
          .widest = std::max(widest * std::max(width, height), 4.0f),
          .pixel_area = static_cast<float>(context.camera->window_area() / pixels),
          .intensity = caustic_intensity(context),
          .beams_a_side = beams_a_side(*context.settings),
          .medium = shader_medium(*context.scene)};
}

}  // namespace

Pass light_shafts_pass() {
  return {
      .name = "light_shafts",
      .purpose = "draws what the medium scatters of the casters' light on its way",
      .reason = "the medium scatters the casters' light",
      .when = {&Effects::light_shafts},
      .drawn_for = {kBranch},
      .only_lights_with_caustics = true,
      .draws = DrawSet::Beams,
      .reads = {{.name = "beam_start", .meaning = "where each beam starts, and its length"},
                {.name = "beam_way", .meaning = "its direction"},
                {.name = "beam_flux", .meaning = "its flux"},
                {.name = "view_range", .meaning = "what hides it"}},
      .writes = {{.name = "haze",
                  .meaning = "rgb: radiance that the medium scatters towards the camera, nit",
                  .blend = kAccumulate}},
      .owner = Each::Frame,
      .shaders = {{&light_shafts_shader, block_of<light_shafts_uniforms>}},
  };
}

}  // namespace caustics
