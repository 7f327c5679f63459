#pragma once
#include <glm/glm.hpp>

#include "pipeline/plan/pass.hpp"

namespace caustics {

// The uniform block of passes that draw opaque surfaces into a frame and cut out alpha masks.
struct ReceiverMapUniforms {
  using vec4 = glm::vec4;
  using mat4 = glm::mat4;
#include "passes/receiver_map/receiver_map_uniforms.glsl"
};
// `frames`: keep the space between light and casters free; null: keep all.
ReceiverMapUniforms receiver_map_uniforms(const View& view, const Material& material,
                                          const LightViews* views = nullptr);

// receiver_map.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass receiver_map_pass();

}  // namespace caustics
