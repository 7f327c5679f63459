// Whether a light's caustic is small enough in its map for a finer second one to be worth it. Before a pilot
// has shown where the light lands, nobody knows.
#pragma once
#include <vector>

#include "pipeline/effects/effects.hpp"

namespace caustics {

// Finer texels need more splats each, but not more cells; but of a coarse grid they would show each cell.
bool can_have_cascades(const Settings& settings);
// The reason where none can be had, or where none was found worth it.
std::string why_no_cascades(const Settings& settings);

// What a pilot finds of one light.
struct PilotFinding {
  double cascades_in_map =
      0.0;  // how many times its cascade's window fits into the map's, by area; 0: no cascade
  bool out_of_sight = false;  // the camera sees nothing of what its casters light and shade
};

// The effects with what the pilot found of every light (by Scene::lights): final.
Effects with_findings(Effects effects, const Settings& settings, const std::vector<PilotFinding>& findings);

}  // namespace caustics
