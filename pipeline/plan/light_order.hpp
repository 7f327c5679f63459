// The order in which a plan's passes run.
#pragma once
#include "pipeline/plan/frame_plan.hpp"

namespace caustics {

// Each light's passes one after the other, light by light, so that a light's textures can take the memory of
// the light before. A pass that needs those of several lights follows them all. What one pass finds written
// by others stays the same, but for where light joins light in one texture: sums run light by light. Marks
// the last pass of each light.
void order_by_light(FramePlan& plan);

}  // namespace caustics
