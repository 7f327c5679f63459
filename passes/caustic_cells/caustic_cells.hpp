#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) CausticCells {
#include "passes/caustic_cells/caustic_cells_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// caustic_cells.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass caustic_cells_pass();

}  // namespace caustics
