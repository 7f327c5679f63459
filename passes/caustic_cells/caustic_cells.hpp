#pragma once
#include <glm/glm.hpp>

#include "pipeline/plan/pass.hpp"

namespace caustics {

struct CausticCellsUniforms {
  using ivec4 = glm::ivec4;
#include "passes/caustic_cells/caustic_cells_uniforms.glsl"
};

// caustic_cells.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass caustic_cells_pass();

}  // namespace caustics
