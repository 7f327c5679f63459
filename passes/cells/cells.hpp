#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct Cells {
#include "passes/cells/cells_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// When four landings are one cell (cells.md).
struct CellLimits {
  float jump = 3.0f;           // times its neighbours' length an edge may be long ...
  float smallest_jump = 2.0f;  // ... or so many texels
  // Of light that was followed: times a differential that a landing may be off the place which both expect.
  float expected = 0.5f;
  // Of the map's side, that a cell may span; and texels: points are drawn up to this size everywhere.
  float largest_share = 0.25f;
  float largest = 254.0f;
  float gap = 2.0f;  // between the receiver and the cell's middle, in texels' extents
};

// cells.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass cells_pass();

}  // namespace caustics
