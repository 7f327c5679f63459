// The branches of a light's flux (effects.hpp): what dispersing and mirroring glass calls for.
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// Adds the effects "dispersion" and "reflections" to those that are there already, and sets the branches.
// Ways that light takes through rough glass, and rays that the camera's view does.
inline constexpr int kRoughWays = 16;

void add_branches(const Scene& scene, const Settings& settings, Effects& effects);

}  // namespace caustics
