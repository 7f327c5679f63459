// A second caustic map for the part of a light's caustic where most of its flux falls on little of the first.
//
// The first map holds all flux and is what the ledger counts. The cascade shows a part of it again through a smaller
// window, finer by as much; shading takes the cascade where it reaches and the first map elsewhere
// (passes/cascade_map/cascade_map.md).
#pragma once
#include <optional>
#include <vector>

#include "pipeline/plan/landing_window.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

// Finer texels need more splats each, but not more cells; but of a coarse grid they would show each cell.
bool can_have_cascades(const Settings& settings);

// A caustic frame narrowed to the window that makes the mean side of a texel, weighted by the flux on it, least;
// nothing where that would not be less than half of what it is in the map around all.
std::optional<Frame> cascade_frame(const Frame& caustic, const LandedFlux& landed, double margin,
                                   double shortest = 1e-9);

// The effect "cascades" before the lights' frames are known: inactive.
void add_cascades(const Settings& settings, Effects& effects);
// And once they are, by light.
void judge_cascades(const std::vector<LightFrames>& frames, const Settings& settings, Effects& effects);

}  // namespace caustics
