#include "passes/tone_map/tone_map.hpp"

#include <glm/glm.hpp>

namespace caustics {

extern const Shader tone_map_shader;

namespace {

struct ToneMapUniforms {
  using vec4 = glm::vec4;
#include "passes/tone_map/tone_map_uniforms.glsl"
};

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
      .shaders = {{&tone_map_shader}},
      .uniforms =
          [](const PassContext& context) {
            return uniform_bytes(ToneMapUniforms{.exposure = {context.exposure, 0.0f, 0.0f, 0.0f}});
          },
  };
}

}  // namespace caustics
