// Whether caustics have a colour of their own, beside the light's: what decides the caustic map's channels.
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// Adds the effect "coloured caustics" to those that are there already; the branches must be set.
void add_caustic_color(const Scene& scene, Effects& effects);

}  // namespace caustics
