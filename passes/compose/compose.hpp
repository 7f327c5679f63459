#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// compose.md says what these passes are for, what is read and written, and what can go wrong.
Pass compose_pass();

}  // namespace caustics
