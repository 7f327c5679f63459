#include "passes/view_medium/view_medium.hpp"

#include "passes/shared/medium_uniforms.hpp"

namespace caustics::std140 {

struct ViewMedium {
#include "passes/view_medium/view_medium_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader view_medium_shader;

namespace {

std140::ViewMedium medium_uniforms(const PassContext& context) {
  return {.medium = shader_medium(*context.scene)};
}

}  // namespace

Pass view_medium_pass() {
  return {
      .name = "view_medium",
      .purpose = "takes from the picture what the medium takes on the way to the camera",
      .reason = "a medium lies between the camera and what it sees",
      .when = {&Effects::medium},
      .reads = {{.name = "view_range", .meaning = "how far each ray goes through the medium"}},
      .writes = {{.name = "beauty",
                  .meaning = "rgb: radiance towards the camera, nit; a: 1",
                  .blend = kMultiply,
                  .mask = kColorWithoutAlpha}},
      .shaders = {{&view_medium_shader, block_of<medium_uniforms>}},
  };
}

}  // namespace caustics
