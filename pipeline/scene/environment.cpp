#include "pipeline/scene/environment.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

float times(float radiance, double strength) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return static_cast<float>(std::min(strength * static_cast<double>(radiance), kMost));
}

struct Turn {
  double sine = 0.0, cosine = 1.0;
};

Turn turn_of(double angle) {
  Turn turn;
  exact::sin_cos(angle, turn.sine, turn.cosine);
  return turn;
}

}  // namespace

void adjust(Environment& environment, double strength, double degrees) {
  const double turn = degrees * (exact::kPi / 180.0);
  const auto strengthen = [strength](glm::vec3& color) {
    for (int c = 0; c < 3; ++c) color[c] = times(color[c], strength);
  };
  for (glm::vec3* color : {&environment.zenith, &environment.horizon, &environment.ground})
    strengthen(*color);
  if (environment.backdrop) strengthen(*environment.backdrop);
  environment.boxes_mean = times(environment.boxes_mean, strength);
  const Turn turned = turn_of(turn);
  for (SoftBox& box : environment.boxes) {
    box.radiance = times(box.radiance, strength);
    for (glm::dvec3* way : {&box.middle, &box.across, &box.upward})
      *way = {way->x * turned.cosine + way->z * turned.sine, way->y,
              way->z * turned.cosine - way->x * turned.sine};
  }
  environment.turn = {turned.cosine, turned.sine};
  if (!environment.image) return;
  std::vector<float>& values = environment.image->values;
  for (std::size_t i = 0; strength != 1.0 && i < values.size(); ++i)
    if (i % 4 != 3) values[i] = times(values[i], strength);
  environment.ambient = environment_irradiance(*environment.image, turn);
}

std::array<glm::vec3, 9> environment_irradiance(const Image& environment, double turn) {
  std::array<glm::dvec3, 9> sums{};
  double solid_angle = 0.0;
  const int width = environment.width(), height = environment.height();
  std::vector<Turn> columns;
  columns.reserve(static_cast<std::size_t>(width));
  for (int column = 0; column < width; ++column)
    columns.push_back(turn_of(((column + 0.5) / width - 0.5) * 2.0 * exact::kPi - turn));
  for (int row = 0; row < height; ++row) {
    const Turn rise = turn_of(((row + 0.5) / height - 0.5) * exact::kPi);
    for (int column = 0; column < width; ++column) {
      const Turn& around = columns[static_cast<std::size_t>(column)];
      const double x = rise.cosine * around.sine, y = rise.sine, z = -rise.cosine * around.cosine;
      const double basis[9] = {1.0, y, z, x, x * y, y * z, 3.0 * z * z - 1.0, x * z, x * x - y * y};
      for (std::size_t i = 0; i < 9; ++i)
        for (int c = 0; c < 3; ++c)
          sums[i][c] += rise.cosine * basis[i] * static_cast<double>(environment.at(column, row, c));
      solid_angle += rise.cosine;
    }
  }
  // Means over the sphere, times the basis' norm and the cosine lobe's factor over pi (1, 2/3, 1/4).
  const double factors[9] = {1.0,         2.0,         2.0,         2.0,        15.0 * 0.25,
                             15.0 * 0.25, 1.25 * 0.25, 15.0 * 0.25, 3.75 * 0.25};
  std::array<glm::vec3, 9> result;
  for (std::size_t i = 0; i < 9; ++i) {
    const glm::dvec3 mean = sums[i] * (factors[i] / solid_angle);
    constexpr double kMost = std::numeric_limits<float>::max();
    result[i] = glm::vec3(glm::clamp(mean, glm::dvec3(-kMost), glm::dvec3(kMost)));
  }
  return result;
}

namespace {

double upward(const glm::dvec3& mean_radiance) {
  return exact::kPi * std::max(exact::luminance(mean_radiance), 0.0);
}

}  // namespace

double upward_irradiance(const std::array<glm::vec3, 9>& ambient) {
  return upward((glm::dvec3(ambient[0]) + glm::dvec3(ambient[1])) -
                (glm::dvec3(ambient[6]) + glm::dvec3(ambient[8])));
}

double upward_irradiance(const Environment& environment) {
  if (environment.image) return upward_irradiance(environment.ambient);
  // A gradient as compose.glsl takes it.
  return upward((glm::dvec3(environment.horizon) + glm::dvec3(environment.zenith) * 2.0) / 3.0 +
                glm::dvec3(static_cast<double>(environment.boxes_mean)));
}

}  // namespace caustics
