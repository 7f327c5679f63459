// The irradiance that an environment image gives a surface, by its normal.
#pragma once
#include <array>
#include <glm/glm.hpp>

#include "pipeline/gpu/image.hpp"

namespace caustics {

// Nine coefficients a colour channel, such that sum c_i b_i(n) is the irradiance at unit normal n over pi,
// with b = 1, y, z, x, xy, yz, 3zz - 1, xz, xx - yy: the image's second-order spherical harmonics,
// convolved with the cosine (Ramamoorthi and Hanrahan 2001; average error about 1 %). The image is
// equirectangular, RGBA32F, its middle along -z.
std::array<glm::vec3, 9> environment_irradiance(const Image& environment);

}  // namespace caustics
