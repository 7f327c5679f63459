#include "passes/tone_map/tone_map.hpp"

#include <algorithm>

#include "pipeline/settings/settings.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) ToneMap {
#include "passes/tone_map/tone_map_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader tone_map_shader;

namespace {

int is_linear(const PassContext& context) {
  return context.settings && context.settings->tone_map == ToneMap::Linear ? 1 : 0;
}

// Of the contrast over 1, which darkness gets half of.
constexpr float kMostInDark = 0.6f;

std140::ToneMap tone_map_uniforms(const PassContext& context) {
  const bool is_film = !context.settings || context.settings->tone_map == ToneMap::Film;
  const float contrast = is_film ? context.contrast : 1.0f;
  return {.exposure = context.exposure,
          .contrast = contrast,
          .contrast_in_dark = 1.0f + 0.5f * std::min(contrast - 1.0f, kMostInDark)};
}

}  // namespace

Pass tone_map_pass() {
  return {
      .name = "tone_map",
      .purpose = "turns radiance into what a screen shows",
      .reason = "a picture for a screen is wanted",
      .reads = {{.name = "beauty", .meaning = "radiance, nit"}},
      .writes = {{.name = "picture",
                  .format = Format::RGBA8,
                  .meaning = "rgb: sRGB-encoded display values; a: 1"}},
      .shaders = {{&tone_map_shader, block_of<tone_map_uniforms>}},
      .choices = {{"is_linear", is_linear}},
  };
}

}  // namespace caustics
