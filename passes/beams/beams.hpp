#pragma once
#include <glm/glm.hpp>

#include "pipeline/plan/pass.hpp"

namespace caustics {

struct BeamsUniforms {
  using ivec4 = glm::ivec4;
#include "passes/beams/beams_uniforms.glsl"
};

// beams.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass beams_pass();

}  // namespace caustics
