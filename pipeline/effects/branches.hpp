// The branches of a light's flux (effects.hpp): what dispersing and mirroring glass calls for.
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// Branches that each branch becomes where there is rough glass.
int ways_through_rough_glass(const Settings& settings);

// Adds the effects "dispersion" and "reflections" to those that are there already, and sets the branches.
void add_branches(const Scene& scene, const Settings& settings, Effects& effects);

}  // namespace caustics
