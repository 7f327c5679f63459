// Lights that stand so far away that their light is parallel.
#pragma once
#include "pipeline/scene/scene.hpp"

namespace caustics {

// A light this many times as far from the scene's middle as the scene's radius. Depths along its way are
// drawn in single precision, in steps of 2^-24 of the distance; parallel light misses directions by the
// radius over the distance. Here both are 2^-12 of the scene's radius.
inline constexpr double kFarLight = 4096.0;

// What a light of candela sends in a direction (unit) over its intensity: 0 to 1.
double cone_falloff(const Light& light, const glm::dvec3& direction);

// Makes point and spot lights among Scene::lights that are farther than kFarLight directional, with the
// illuminance that they give at the scene's middle, and says so in Scene::notes. Scene::sources, samples of
// lights with a size, and lights whose range ends before the middle are left as they are.
void make_far_lights_parallel(Scene& scene);

}  // namespace caustics
