#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) LightStep {
#include "passes/light_step/light_step_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// light_step.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass light_step_pass();

}  // namespace caustics
