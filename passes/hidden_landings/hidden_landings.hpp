#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) HiddenLandings {
#include "passes/hidden_landings/hidden_landings_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// hidden_landings.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass hidden_landings_pass();

}  // namespace caustics
