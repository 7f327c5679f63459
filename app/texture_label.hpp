// What people read in place of a texture's name.
#pragma once
#include <string>

#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics::app {

// As its passes are labelled, by the light's name: "caustic_map[sun].cascade" for "caustic_map.cascade[0]".
// Dumps and digests keep the numbers, which no two lights share.
std::string texture_label(const PlannedTexture& texture, const Scene& scene);

}  // namespace caustics::app
