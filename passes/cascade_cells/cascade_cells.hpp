#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct alignas(16) CascadeCells {
#include "passes/cascade_cells/cascade_cells_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// cascade_cells.md says what these passes are for, what they read and write, and what can go wrong.
Pass cascade_cells_pass();

}  // namespace caustics
