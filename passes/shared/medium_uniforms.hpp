// What shaders get of the medium.
#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics {

namespace std140 {
#include "passes/shared/homogeneous_medium.glsl"
}  // namespace std140

// Zeros without a medium.
std140::Medium shader_medium(const Scene& scene);

// A pass's uniforms with `Medium medium` behind them, for the variant of its shader with HAZE.
UniformBytes with_medium(UniformBytes bytes, const Scene& scene);

}  // namespace caustics
