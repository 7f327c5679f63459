#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) NextSurface {
#include "passes/next_surface/next_surface_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// next_surface.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass next_surface_pass();

}  // namespace caustics
