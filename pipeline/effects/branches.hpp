// The branches of a light's flux (effects.hpp): what dispersing and mirroring glass calls for.
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// Is light followed, and every caster rough glass?
bool all_light_is_spread(const Effects& effects);

// Adds the effects "dispersion" and "reflections" to those that are there already, and sets the branches.
void add_branches(const Scene& scene, const Settings& settings, Effects& effects);

}  // namespace caustics
