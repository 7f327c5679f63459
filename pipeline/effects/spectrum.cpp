#include "pipeline/effects/spectrum.hpp"

#include <algorithm>

namespace caustics {

namespace {

constexpr double kFirst = 400.0, kLast = 700.0;

// CIE 1931 2-degree colour matching functions (CIE 018:2019, table 6) from 400 to 700 nm, every 10 nm.
constexpr double kMatching[31][3] = {
    {0.014310, 0.000396, 0.067850}, {0.043510, 0.001210, 0.207400}, {0.134380, 0.004000, 0.645600},
    {0.283900, 0.011600, 1.385600}, {0.348280, 0.023000, 1.747060}, {0.336200, 0.038000, 1.772110},
    {0.290800, 0.060000, 1.669200}, {0.195360, 0.090980, 1.287640}, {0.095640, 0.139020, 0.812950},
    {0.032010, 0.208020, 0.465180}, {0.004900, 0.323000, 0.272000}, {0.009300, 0.503000, 0.158200},
    {0.063270, 0.710000, 0.078250}, {0.165500, 0.862000, 0.042160}, {0.290400, 0.954000, 0.020300},
    {0.433450, 0.994950, 0.008750}, {0.594500, 0.995000, 0.003900}, {0.762100, 0.952000, 0.002100},
    {0.916300, 0.870000, 0.001650}, {1.026300, 0.757000, 0.001100}, {1.062200, 0.631000, 0.000800},
    {1.002600, 0.503000, 0.000340}, {0.854450, 0.381000, 0.000190}, {0.642400, 0.265000, 0.000050},
    {0.447900, 0.175000, 0.000020}, {0.283500, 0.107000, 0.000000}, {0.164900, 0.061000, 0.000000},
    {0.087400, 0.032000, 0.000000}, {0.046770, 0.017000, 0.000000}, {0.022700, 0.008210, 0.000000},
    {0.011359, 0.004102, 0.000000}};

// Between the table's entries by straight lines.
glm::dvec3 matching(double nanometres) {
  const double at = std::clamp((nanometres - kFirst) / 10.0, 0.0, 30.0);
  const int below = std::min(static_cast<int>(at), 29);
  const double part = at - below;
  glm::dvec3 result;
  for (int c = 0; c < 3; ++c) result[c] = kMatching[below][c] * (1.0 - part) + kMatching[below + 1][c] * part;
  return result;
}

glm::dvec3 srgb_of_xyz(const glm::dvec3& v) {
  return {(3.2406 * v.x - 1.5372 * v.y) - 0.4986 * v.z, (-0.9689 * v.x + 1.8758 * v.y) + 0.0415 * v.z,
          (0.0557 * v.x - 0.2040 * v.y) + 1.0570 * v.z};
}

glm::dvec3 band_color(double from, double to) {
  constexpr int kSteps = 64;
  glm::dvec3 sum(0.0);
  for (int i = 0; i < kSteps; ++i) sum += matching(from + (to - from) * (i + 0.5) / kSteps);
  return srgb_of_xyz(sum / double(kSteps));
}

}  // namespace

std::vector<Wavelength> fraunhofer_lines() {
  return {{kLineC, {1.0f, 0.0f, 0.0f}}, {kLineD, {0.0f, 1.0f, 0.0f}}, {kLineF, {0.0f, 0.0f, 1.0f}}};
}

std::vector<Wavelength> spectrum(int count) {
  const double width = (kLast - kFirst) / count;
  std::vector<glm::dvec3> colors;
  colors.reserve(static_cast<std::size_t>(count));
  glm::dvec3 white(0.0);
  for (int i = 0; i < count; ++i) {
    colors.push_back(band_color(kFirst + width * i, kFirst + width * (i + 1)));
    white += colors.back();
  }
  std::vector<Wavelength> result;
  result.reserve(colors.size());
  for (int i = 0; i < count; ++i)
    result.push_back({kFirst + width * (i + 0.5), glm::vec3(colors[static_cast<std::size_t>(i)] / white)});
  return result;
}

double bend_of(double nanometres) {
  const auto inverse_square = [](double x) { return 1.0 / (x * x); };
  return (inverse_square(nanometres) - inverse_square(kLineD)) /
         (inverse_square(kLineF) - inverse_square(kLineC));
}

}  // namespace caustics
