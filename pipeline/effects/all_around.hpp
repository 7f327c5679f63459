// Whether something has to be seen in every direction instead of through a window: the surroundings of the
// casters, for distance impostors, and those of a light that stands among its casters.
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// Judges distance_impostors and all_around, by the expectations, caustics and scattering.
void add_all_around(const Scene& scene, const Settings& settings, Effects& effects);

}  // namespace caustics
