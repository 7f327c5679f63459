// Wavelengths at which a dispersing scene is simulated, and the colour that each one's light has.
#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace caustics {

// The Fraunhofer lines by which glass is catalogued, nanometres (KHR_materials_dispersion).
inline constexpr double kLineC = 656.3, kLineD = 587.6, kLineF = 486.1;

struct Wavelength {
  double nanometres = kLineD;
  // Linear sRGB of an equal share of a white light. Over all wavelengths each channel adds up to 1, so that
  // what is not dispersed stays white; single ones lie outside of sRGB's gamut and have negative channels.
  glm::vec3 color{1.0f};
};

// Red, green and blue at the C, d and F lines.
std::vector<Wavelength> fraunhofer_lines();

// The middles of `count` equal bands from 400 to 700 nm, each with the integral over its band of the CIE 1931
// 2-degree colour matching functions, in linear sRGB (IEC 61966-2-1).
std::vector<Wavelength> spectrum(int count);

// (n - n_d) / (n_F - n_C) by Cauchy's n = A + B / wavelength^2: 0 at the d line.
double bend_of(double nanometres);

}  // namespace caustics
