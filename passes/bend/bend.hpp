#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// bend.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass bend_pass();

}  // namespace caustics
