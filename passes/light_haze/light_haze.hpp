#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// light_haze.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass light_haze_pass();

}  // namespace caustics
