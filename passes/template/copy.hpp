#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// copy.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass copy_pass();

}  // namespace caustics
