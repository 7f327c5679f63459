#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// pane_light.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass pane_light_pass();

}  // namespace caustics
