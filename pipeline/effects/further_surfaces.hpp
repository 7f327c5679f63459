// Whether light is followed from surface to surface: where more than a named share of what lands would else
// be drawn elsewhere or not at all.
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// Why it cannot be, whatever a pilot finds; empty where it can.
std::string why_not_followed(const Settings& settings, const Effects& effects);

// The effects with what a pilot has found, and with the branches that light is followed by.
Effects with_further_surfaces(Effects effects, const Settings& settings, std::vector<FurtherShare> shares);

}  // namespace caustics
