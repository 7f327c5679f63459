#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// enter.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass enter_pass();

}  // namespace caustics
