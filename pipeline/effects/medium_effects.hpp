// Haze in the air, as effects.
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// Adds "medium", "scattering" and "light shafts"; needs "light" and "caustics" in the list.
void add_medium(const Scene& scene, Effects& effects);

}  // namespace caustics
