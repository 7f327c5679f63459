#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) CausticFootprints {
#include "passes/caustic_footprints/caustic_footprints_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// caustic_footprints.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass caustic_footprints_pass();

}  // namespace caustics
