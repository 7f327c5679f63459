#pragma once
#include "passes/shared/medium_uniforms.hpp"

namespace caustics::std140 {

struct LightShafts {
#include "passes/light_shafts/light_shafts_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// light_shafts.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass light_shafts_pass();

}  // namespace caustics
