#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) AmbientRays {
#include "passes/ambient_rays/ambient_rays_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// Pixels a side that one texel of this pass and of ambient_occlusion stands for.
inline constexpr int kAmbientPixels = 4;

// ambient_rays.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass ambient_rays_pass();

}  // namespace caustics
