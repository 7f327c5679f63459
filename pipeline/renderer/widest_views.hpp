// Where a light looks before anything is known of where its light lands.
#pragma once
#include "pipeline/effects/effects.hpp"
#include "pipeline/views/light_views.hpp"

namespace caustics {

// Windows around all the casters and all the receivers, so that the maps leave nothing out. `grid`: vertices
// a side, whose splats widen the casters' window. Of a light that sees all around: its cubes
// (views_all_around).
LightViews widest_views(const Scene& scene, const Effects& effects, const Settings& settings, int light);

}  // namespace caustics
