#pragma once
#include <glm/glm.hpp>

#include "pipeline/plan/pass.hpp"

namespace caustics {

struct CascadeMapUniforms {
  using vec4 = glm::vec4;
  using ivec4 = glm::ivec4;
#include "passes/cascade_map/cascade_map_uniforms.glsl"
};

// cascade_map.md says what these passes are for, what they read and write, and what can go wrong.
Pass cascade_cells_pass();

}  // namespace caustics
