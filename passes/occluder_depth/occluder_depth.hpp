#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// occluder_depth.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass occluder_depth_pass();

}  // namespace caustics
