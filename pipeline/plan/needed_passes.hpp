// Which of a plan's passes, reads and attachments a goal depends on.
#pragma once
#include "pipeline/plan/frame_plan.hpp"

namespace caustics {

// The plan without what the goal's textures do not depend on.
FramePlan needed_for(const PlanGoal& goal, FramePlan plan);

// Leaves out the textures that no pass of the plan uses, and numbers the others anew.
void keep_used_textures(FramePlan& plan);

}  // namespace caustics
