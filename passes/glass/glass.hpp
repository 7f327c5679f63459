#pragma once
#include "passes/shared/sky_uniforms.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) Glass {
#include "passes/glass/glass_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// glass.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass glass_pass();

}  // namespace caustics
