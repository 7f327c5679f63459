#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) Beams {
#include "passes/beams/beams_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// beams.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass beams_pass();

// 1: each vertex of the branch draws its own way, so that neighbours' light is no beam together; else 0.
int goes_own_ways(const PassContext& context);

}  // namespace caustics
