#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// view_medium.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass view_medium_pass();

}  // namespace caustics
