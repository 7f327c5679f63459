#pragma once
#include "passes/shared/light_uniforms.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct Landing {
#include "passes/landing/landing_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// How far from its surface a ray may end and still count as having met it, in texels' extents.
inline constexpr float kExitTolerance = 2.0f;
inline constexpr float kLandingTolerance = 2.0f;

// landing.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass landing_pass();

}  // namespace caustics
