// Haze in the air, as effects.
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// Judges medium, scattering and light_shafts, by light and caustics.
void add_medium(const Scene& scene, Effects& effects);

}  // namespace caustics
