#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// caustic_footprints.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass caustic_footprints_pass();

}  // namespace caustics
