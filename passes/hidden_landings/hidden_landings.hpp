#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// hidden_landings.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass hidden_landings_pass();

}  // namespace caustics
