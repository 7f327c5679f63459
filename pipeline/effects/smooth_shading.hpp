// Whether shadows end by the diffuse surfaces' own normals instead of by their triangles.
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// Sets `smooth_shading`. Builds on surfaces and occluders.
void add_smooth_shading(const Scene& scene, Effects& effects);

}  // namespace caustics
