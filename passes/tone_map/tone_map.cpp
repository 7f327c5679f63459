#include "passes/tone_map/tone_map.hpp"

#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) ToneMap {
#include "passes/tone_map/tone_map_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader tone_map_shader;

Pass tone_map_pass() {
  return {.definition =
              {.name = "tone_map",
               .purpose = "turns radiance into what a screen shows",
               .reads = {{.name = "beauty", .meaning = "radiance, nit"}},
               .writes = {{.name = "picture",
                           .format = Format::RGBA8,
                           .meaning = "rgb: sRGB-encoded display values; a: 1"}},
               .shader = &tone_map_shader},
          .called_for_by = [](const Effects&) -> std::optional<std::string> {
            return "a picture for a screen is wanted";
          },
          .extent = Extent::Picture,
          .uniforms =
              [](const PassContext& context) {
                return uniform_bytes(std140::ToneMap{.exposure = context.exposure});
              }};
}

}  // namespace caustics
