#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// ambient_occlusion.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass ambient_occlusion_pass();

}  // namespace caustics
