#pragma once
#include <glm/glm.hpp>

#include "pipeline/plan/pass.hpp"

namespace caustics {

struct LightShaftsUniforms {
  using vec4 = glm::vec4;
  using mat4 = glm::mat4;
  using ivec4 = glm::ivec4;
#include "passes/light_shafts/light_shafts_uniforms.glsl"
};

// light_shafts.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass light_shafts_pass();

}  // namespace caustics
