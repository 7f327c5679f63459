#include "passes/compose/environment_irradiance.hpp"

#include "pipeline/scene/exact.hpp"

namespace caustics {

std::array<glm::vec3, 9> environment_irradiance(const Image& environment) {
  std::array<glm::dvec3, 9> sums{};
  double solid_angle = 0.0;
  const int width = environment.width(), height = environment.height();
  for (int row = 0; row < height; ++row) {
    double sine, cosine;
    exact::sin_cos(((row + 0.5) / height - 0.5) * exact::kPi, sine, cosine);
    for (int column = 0; column < width; ++column) {
      double turn_sine, turn_cosine;
      exact::sin_cos(((column + 0.5) / width - 0.5) * 2.0 * exact::kPi, turn_sine, turn_cosine);
      const double x = cosine * turn_sine, y = sine, z = -cosine * turn_cosine;
      const double basis[9] = {1.0, y, z, x, x * y, y * z, 3.0 * z * z - 1.0, x * z, x * x - y * y};
      for (std::size_t i = 0; i < 9; ++i)
        for (int c = 0; c < 3; ++c)
          sums[i][c] += cosine * basis[i] * static_cast<double>(environment.at(column, row, c));
      solid_angle += cosine;
    }
  }
  // Means over the sphere, times the basis' norm and the cosine lobe's factor over pi (1, 2/3, 1/4).
  const double factors[9] = {1.0,         2.0,         2.0,         2.0,        15.0 * 0.25,
                             15.0 * 0.25, 1.25 * 0.25, 15.0 * 0.25, 3.75 * 0.25};
  std::array<glm::vec3, 9> result;
  for (std::size_t i = 0; i < 9; ++i) result[i] = glm::vec3(sums[i] * (factors[i] / solid_angle));
  return result;
}

}  // namespace caustics
