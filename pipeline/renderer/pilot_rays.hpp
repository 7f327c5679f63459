// A few thousand rays of a light onto its casters, by which a pilot learns where its light goes.
#pragma once
#include <cstddef>
#include <vector>

#include "pipeline/measure/light_paths.hpp"

namespace caustics {

// kPilotRaysASide a side through the light's view of its casters, each with a flux of 1 and a key of its own.
// A share of 5 % is known to 0.5 % by as many. Each lies somewhere else in its square, so that no pattern of
// the casters' own is met at its crests alone. Of these, each `step`th along each side.
inline constexpr int kPilotRaysASide = 48;
std::vector<LightRay> pilot_rays(const Light& light, const View& casters, int step = 1);

// The step for so many lights: with more than 16 all of them together have about as many rays as those.
int pilot_step(std::size_t lights);

// Those that throw caustics, by Scene::lights; of the samples of a light with a size those that are drawn for
// all, or else the first alone.
std::vector<int> lights_to_pilot(const Scene& scene, const Effects& effects);

}  // namespace caustics
