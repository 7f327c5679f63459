// Which textures of a plan share memory.
#pragma once
#include "pipeline/plan/frame_plan.hpp"

namespace caustics {

// Gives every texture that a pass writes its memory. Textures of one format and size that are not kept, and
// of which one is read for the last time before the other is written, share theirs.
void share_memory(FramePlan& plan);

// The plan with its passes in the order (light_order.hpp) in which its textures share most memory. A light's
// maps are needed until the last sample is drawn, or else, light by light, what all samples have seen of the
// lights before: the bits are the same. Without samples both orders are one.
FramePlan in_least_memory(FramePlan plan);

}  // namespace caustics
