// The only list of passes.
#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// Every pass, in the order in which they run.
const Registry& pass_registry();

}  // namespace caustics
