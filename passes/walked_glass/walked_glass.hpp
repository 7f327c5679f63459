#pragma once
#include "passes/shared/sky_uniforms.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) WalkedGlass {
#include "passes/walked_glass/walked_glass_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// walked_glass.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass walked_glass_pass();

}  // namespace caustics
