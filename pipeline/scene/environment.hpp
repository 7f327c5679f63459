// The light from all around: how strong it is, how it is turned, what an image of it gives to a surface.
#pragma once
#include <array>

#include "pipeline/scene/scene.hpp"

namespace caustics {

// Multiplies its radiance and turns it about the vertical, by degrees, anticlockwise as seen from above.
// Then its ambient light is known.
void adjust(Environment& environment, double strength, double degrees);

// The irradiance over pi by a surface's normal: spherical harmonics up to order 2, convolved with the cosine
// (Ramamoorthi and Hanrahan 2001). Coefficients of 1, y, z, x, xy, yz, 3zz-1, xz, xx-yy. `turn`: radians.
std::array<glm::vec3, 9> environment_irradiance(const Image& environment, double turn = 0.0);

// What it gives a surface that faces up, lux, by luminance.
double upward_irradiance(const Environment& environment);
// The same of environment_irradiance's coefficients.
double upward_irradiance(const std::array<glm::vec3, 9>& ambient);

}  // namespace caustics
