#include "passes/view_range/view_range.hpp"

#include "passes/shared/camera_rays.hpp"
#include "passes/shared/medium_uniforms.hpp"

namespace caustics::std140 {

struct ViewRange {
#include "passes/view_range/view_range_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader view_range_shader;

namespace {

std140::ViewRange range_uniforms(const PassContext& context) {
  return {.camera = shader_camera_rays(*context.camera, context.width, context.height),
          .view = shader_view(*context.camera),
          .medium = shader_medium(*context.scene)};
}

}  // namespace

Pass view_range_pass() {
  return {
      .name = "view_range",
      .purpose = "finds how far each of the camera's rays goes through the medium",
      .reason = "a medium lies between the camera and what it sees",
      .when = {&Effects::medium},
      .reads = {{.name = "view_position", .meaning = "opaque surfaces"},
                {.name = "view_normal", .meaning = "their depth"},
                {.name = "view_caster_position",
                 .meaning = "glass and mirrors",
                 .texture_by = casters_beyond_panes,
                 .optional = true}},
      .writes = {{.name = "view_range",
                  .meaning = "x: depth of the first surface along the camera's axis, metres, 1e30 where "
                             "there is none; y, z: distances from the camera at which its ray enters "
                             "the medium and leaves it or ends"}},
      .shaders = {{&view_range_shader, block_of<range_uniforms>}},
  };
}

}  // namespace caustics
