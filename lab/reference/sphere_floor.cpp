#include "lab/reference/sphere_floor.hpp"

#include <cmath>

namespace caustics {

SphereFloorError compare_with_sphere(const std::vector<double>& picture, const GlassSphere& sphere,
                                     double side) {
  const int pixels = static_cast<int>(std::lround(std::sqrt(static_cast<double>(picture.size()))));
  const FloorSquare square{.lower = glm::dvec2(-0.5 * side), .side = side, .pixels = pixels};
  const FloorIrradiance truth = irradiance_average(sphere, square);
  const double pixel = side / pixels;
  double difference = 0.0, inside = 0.0, picture_flux = 0.0, truth_flux = 0.0;
  std::size_t lit = 0, dark = 0;
  for (int y = 0; y < pixels; ++y)
    for (int x = 0; x < pixels; ++x) {
      const auto i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels) + static_cast<std::size_t>(x);
      const glm::dvec2 lower = square.lower + pixel * glm::dvec2(x, y), upper = lower + pixel;
      const double shadowed = disc_in_box(sphere.radius, lower, upper) / (pixel * pixel);
      const double expected = truth.values[i] + 1.0 - shadowed;
      picture_flux += picture[i];
      truth_flux += expected;
      if (shadowed < 1.0) continue;
      difference += std::fabs(picture[i] - expected);
      inside += expected;
      if (!(truth.values[i] > 0.0)) continue;
      ++lit;
      if (!(picture[i] > 0.0)) ++dark;
    }
  return {difference / inside, picture_flux / truth_flux,
          lit > 0 ? static_cast<double>(dark) / static_cast<double>(lit) : 0.0};
}

}  // namespace caustics
