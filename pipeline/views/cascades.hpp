// A second caustic map for the part of a light's caustic where most of its flux falls on little of the first.
//
// The first map holds all flux and is what the ledger counts. The cascade shows a part of it again through a
// smaller window, finer by as much; shading takes each texel of the first map from one of them alone
// (passes/caustic_cells/caustic_cells.md).
#pragma once
#include <optional>
#include <vector>

#include "pipeline/effects/cascades.hpp"
#include "pipeline/views/landing_window.hpp"
#include "pipeline/views/light_views.hpp"

namespace caustics {

// A caustic view narrowed to the window that makes the mean side of a texel, weighted by the flux on it,
// least; nothing where that would not be less than half of what it is in the map around all.
std::optional<View> cascade_view(const View& caustic, const LandedFlux& landed, double margin,
                                 double shortest = 1e-9);

// The cascade, widened until what of it is looked up is all of each texel of the caustic map that it touches:
// a texel of which it has a part only is not shown by it (passes/light_shading/caustic_lookup.glsl). Nothing
// where its texels are not half as wide as the map's then.
std::optional<View> covering_texels(const View& cascade, const View& caustic, const Settings& settings);

// What the lights' views tell the effects. `camera`: the picture's view; null: it counts as seeing
// everything.
std::vector<PilotFinding> findings_of(const std::vector<LightViews>& views, const Effects& effects,
                                      const View* camera = nullptr);

}  // namespace caustics
