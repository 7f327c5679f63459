// How much of the light on the casters comes from each of many lights.
#pragma once
#include <vector>

#include "pipeline/effects/effects.hpp"

namespace caustics {

// By Scene::sources; nothing where there are no more than kFewLights of them
// (pipeline/effects/dim_lights.hpp). A share is that of the irradiance on some points of a caster which
// opaque surfaces do not hide from the light, on the caster where it is largest. Those lights are left out
// which on no caster give more than `least` of the irradiance all together, taken as large as it can be: at
// the caster's nearest point, and nothing in the way.
std::vector<LightShare> light_shares(const Scene& scene, const Effects& effects, double least);

}  // namespace caustics
