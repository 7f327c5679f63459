#include "luminance/luminance.hpp"

#include "pipeline/shader/std140.hpp"

namespace caustics {

namespace std140 {

struct alignas(16) Luminance {
#include "luminance/luminance_uniforms.glsl"
};

}  // namespace std140

extern const Shader luminance_shader;

}  // namespace caustics

namespace {

// Of linear sRGB: ITU-R BT.709-6, item 3.2.
caustics::std140::Luminance uniforms(const caustics::PassContext&) {
  return {.weights = {0.2126f, 0.7152f, 0.0722f}};
}

}  // namespace

caustics::Pass luminance_pass() {
  using namespace caustics;
  return {
      .name = "luminance",
      .purpose = "the luminance of a picture",
      .reason = "what it writes is wanted",
      .reads = {{.name = "picture", .meaning = "linear red, green, blue"}},
      .writes = {{.name = "luminance", .format = Format::R32F, .meaning = "BT.709 luminance of each texel"}},
      .shaders = {{&luminance_shader, block_of<uniforms>}},
  };
}
