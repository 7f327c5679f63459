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

// A pass's uniform block with `Medium medium` behind it, for the permutation of its shader with HAZE.
template <class Block>
struct InMedium {
  Block block;
  std140::Medium medium;
};
template <auto block>
auto in_medium(const PassContext& context) {
  return InMedium<decltype(block(context))>{block(context), shader_medium(*context.scene)};
}

}  // namespace caustics
