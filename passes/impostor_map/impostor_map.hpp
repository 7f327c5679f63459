#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// impostor_map.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass impostor_map_pass();

}  // namespace caustics
