#pragma once
#include <glm/glm.hpp>

#include "pipeline/plan/pass.hpp"

namespace caustics {

struct LandingUniforms {
  using vec4 = glm::vec4;
  using mat4 = glm::mat4;
  using ivec4 = glm::ivec4;
#include "passes/landing/landing_uniforms.glsl"
};

// How far from its surface a ray may end and still count as having met it, in texels' extents.
inline constexpr float kExitTolerance = 2.0f;
inline constexpr float kLandingTolerance = 2.0f;

LandingUniforms landing_uniforms(const PassContext& context);

// landing.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass landing_pass();

}  // namespace caustics
