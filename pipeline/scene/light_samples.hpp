// Area lights by sampling: each becomes some lights without a size, as the passes draw them.
#pragma once
#include "pipeline/scene/scene.hpp"

namespace caustics {

// Keeps the scene's lights in Scene::sources and puts `count` samples (at least 1), or as many as
// Light::samples says, in the place of each that has a shape, named "sun.00" and so on. One sample stands in
// the middle. Each carries an equal share of the intensity, so that the flux does not depend on `count`; the
// places are a low-discrepancy set, the same in every run; the one nearest the light's middle comes first.
// Each gets its Light::sample_radius; a point's is a ten thousandth of the scene's radius, so that no
// surface, however near, makes the irradiance singular. docs/lights.md says how they are spread.
void sample_lights(Scene& scene, int count);

}  // namespace caustics
