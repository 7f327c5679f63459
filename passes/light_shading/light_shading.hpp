#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// light_shading.md says what these passes are for, what is read and written, and what can go wrong.
Pass light_shading_pass();
}  // namespace caustics
