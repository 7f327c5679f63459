#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// shadow_map.md says what this pass is for, what is read and written, and what can go wrong.
Pass shadow_map_pass();

}  // namespace caustics
