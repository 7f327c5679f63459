#pragma once
#include "passes/shared/light_uniforms.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) CasterFlux {
#include "passes/caster_flux/caster_flux_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// caster_flux.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass caster_flux_pass();

}  // namespace caustics
