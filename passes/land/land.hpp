#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// land.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass land_pass();

}  // namespace caustics
