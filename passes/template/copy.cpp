#include "passes/template/copy.hpp"

namespace caustics {

extern const Shader copy_shader;

PassDefinition copy_pass() {
  return {
      .name = "copy",
      .purpose = "copies a texture texel by texel, each channel times a factor",
      .reads = {{.name = "source", .meaning = "the texture to copy, of the target's size"}},
      .writes = {{.name = "copy",
                  .format = Format::RGBA32F,
                  .meaning = "source * factor, channel by channel"}},
      .shader = &copy_shader,
  };
}

}  // namespace caustics
