// What the lights give to the surfaces in the picture without casters: the layer `direct`.
#pragma once
#include <vector>

#include "lab/reference/tracer/film.hpp"

namespace caustics::tracer {

// Shadow rays a side to a light with a size.
inline constexpr int kShadowRays = 8;

// Lux at each pixel's centre, after shadows; 0 on casters. Rows from the bottom, three values a pixel.
std::vector<float> direct_light(const World& world, const Film& film, int threads);

}  // namespace caustics::tracer
