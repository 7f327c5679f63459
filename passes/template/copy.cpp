#include "passes/template/copy.hpp"

#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) Copy {
#include "passes/template/copy_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader copy_shader;

namespace {

std140::Copy copy_uniforms(const PassContext& context) { return {.factor = context.exposure}; }

}  // namespace

Pass copy_pass() {
  return {
      .name = "copy",
      .purpose = "copies the picture texel by texel, times the exposure",
      .reason = "what it writes is wanted",
      .reads = {{.name = "beauty", .meaning = "radiance, nit"}},
      .writes = {{.name = "copy",
                  .format = Format::RGBA32F,
                  .meaning = "beauty * factor, channel by channel"}},
      .shaders = {{&copy_shader, block_of<copy_uniforms>}},
  };
}

}  // namespace caustics
