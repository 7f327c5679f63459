#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) Bend {
#include "passes/bend/bend_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// bend.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass bend_pass();

}  // namespace caustics
