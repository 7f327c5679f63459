#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// caster_exit_map.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass caster_exit_map_pass();

}  // namespace caustics
