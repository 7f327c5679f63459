#pragma once
#include <glm/glm.hpp>

#include "pipeline/plan/pass.hpp"

namespace caustics {

struct WaterStepUniforms {
  using vec4 = glm::vec4;
#include "passes/water_step/water_step_uniforms.glsl"
};

// The uniforms of the step of this number, counted from rest.
WaterStepUniforms water_step_uniforms(const Water& water, std::int64_t step);

// water_step.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass water_step_pass();

}  // namespace caustics
