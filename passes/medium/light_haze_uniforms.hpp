// What light_haze.glsl gets besides the camera's rays and the medium.
#pragma once
#include "passes/medium/medium_uniforms.hpp"

namespace caustics {

struct LightHazeUniforms {
  using vec4 = glm::vec4;
  using mat4 = glm::mat4;
  using ivec4 = glm::ivec4;
#include "passes/medium/light_haze_uniforms.glsl"
};

}  // namespace caustics
