// Which textures of a plan share memory.
#pragma once
#include "pipeline/plan/frame_plan.hpp"

namespace caustics {

// Gives every texture that a pass writes its memory. Textures of one format and size that are not kept, and
// of which one is read for the last time before the other is written, share theirs.
void share_memory(FramePlan& plan);

}  // namespace caustics
