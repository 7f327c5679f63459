#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// first_hit.md says what this pass is for, what is read and written, and what can go wrong.
Pass first_hit_pass();

}  // namespace caustics
