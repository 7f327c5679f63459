#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// shadow_bounds.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass shadow_bounds_pass();

}  // namespace caustics
