#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) CausticMap {
#include "passes/caustic_map/caustic_map_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// caustic_map.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass caustic_map_pass();

}  // namespace caustics
