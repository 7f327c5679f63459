#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// glass.md says what these passes are for, what is read and written, and what can go wrong.
Pass glass_pass();

}  // namespace caustics
