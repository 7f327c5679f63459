#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// next_surface.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass next_surface_pass();

}  // namespace caustics
