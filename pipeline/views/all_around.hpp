// The views of a light that sees in every direction instead of through a window.
#pragma once
#include "pipeline/effects/effects.hpp"
#include "pipeline/views/light_views.hpp"

namespace caustics {

LightViews views_all_around(const Scene& scene, const Effects& effects, const Settings& settings,
                            const Light& light);

}  // namespace caustics
