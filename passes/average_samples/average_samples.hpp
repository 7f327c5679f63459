#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// average_samples.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass average_samples_pass();

}  // namespace caustics
