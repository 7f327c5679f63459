#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) HiddenEnds {
#include "passes/hidden_ends/hidden_ends_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// hidden_ends.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass hidden_ends_pass();

}  // namespace caustics
