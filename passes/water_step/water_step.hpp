#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) WaterStep {
#include "passes/water_step/water_step_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// The uniforms of the step of this number, counted from rest.
std140::WaterStep water_step_uniforms(const Water& water, std::int64_t step);

// water_step.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass water_step_pass();

}  // namespace caustics
