#include "passes/average_samples/average_samples.hpp"

#include "pipeline/settings/settings.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) AverageSamples {
#include "passes/average_samples/average_samples_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader average_samples_shader;

namespace {

std140::AverageSamples average_samples_uniforms(const PassContext& context) {
  return {.weight = 1.0f / static_cast<float>(samples_a_pixel(*context.settings))};
}

}  // namespace

Pass average_samples_pass() {
  return {
      .name = "average_samples",
      .purpose = "adds up the means of what each pixel's samples see",
      .reason = "a pixel is the mean of several samples",
      .when = {&Effects::sub_pixels},
      .drawn_for = {kSample},
      .reads = {{.name = "one_sample",
                 .meaning = "radiance towards the camera in one sample of each pixel, nit",
                 .texture = "beauty"}},
      .writes = {{.name = "beauty",
                  .meaning = "rgb: radiance towards the camera, nit; a: 1",
                  .blend = kAccumulate}},
      .shaders = {{&average_samples_shader, block_of<average_samples_uniforms>}},
  };
}

}  // namespace caustics
