// The camera's passes once for each sample of a pixel.
#pragma once
#include "pipeline/plan/frame_plan.hpp"

namespace caustics {

// Where the plan has a pass of each sample (Each::Sample), it and those of the camera's passes that what it
// adds up depends on come once for each sample, with textures of their own: "view_position.sample 2". They
// come sample after sample. Those that anything else depends on stay as well: that is seen at the pixels'
// middles.
FramePlan with_samples(FramePlan plan, const Registry& registry, int samples, const PlanGoal& goal);

}  // namespace caustics
