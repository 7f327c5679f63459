#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// view_range.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass view_range_pass();

}  // namespace caustics
