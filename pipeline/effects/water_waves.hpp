// The effect "water waves": meshes that `extras` make water that moves.
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// Throws Error (BadInput) for water whose material is no refractor: waves in anything else would bend
// nothing.
void add_water_waves(const Scene& scene, Effects& effects);

}  // namespace caustics
