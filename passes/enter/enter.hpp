#pragma once
#include "passes/shared/light_uniforms.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) Enter {
#include "passes/enter/enter_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// enter.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass enter_pass();

}  // namespace caustics
