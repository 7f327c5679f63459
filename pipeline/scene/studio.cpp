#include "pipeline/scene/studio.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

// As passes/shared/sky_radiance.glsl has it: full within 0.7 of the half side, smooth to none at its end.
double edge(double x, double half) {
  const double t = std::clamp((half - std::fabs(x)) / (0.3 * half), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Level edges; the middle lies `rise` (its sine) above the horizon in the direction of `way`, level.
SoftBox soft_box(const glm::dvec3& way, double rise, double half_width, double half_height, float radiance) {
  const glm::dvec3 level = exact::normalise(way, {0, 0, -1});
  const double reach = std::sqrt(1.0 - rise * rise);
  const glm::dvec3 middle = level * reach + glm::dvec3(0, rise, 0);
  const glm::dvec3 across(-level.z, 0.0, level.x);
  return {.middle = middle,
          .across = across,
          .upward = exact::cross(across, middle),
          .half_width = half_width,
          .half_height = half_height,
          .radiance = radiance};
}

}  // namespace

double upward_irradiance(const SoftBox& box) {
  // Midpoint rule over the plane at distance 1, which a direction meets at (x, y): d = (m + x a + y u) / w
  // with w^2 = 1 + x^2 + y^2, solid angle dx dy / w^3.
  constexpr int kSteps = 64;
  double sum = 0.0;
  for (int j = 0; j < kSteps; ++j)
    for (int i = 0; i < kSteps; ++i) {
      const double x = (2.0 * (i + 0.5) / kSteps - 1.0) * box.half_width;
      const double y = (2.0 * (j + 0.5) / kSteps - 1.0) * box.half_height;
      const double squared = 1.0 + x * x + y * y;
      const double height = (box.middle.y + x * box.across.y) + y * box.upward.y;
      sum += std::max(height, 0.0) * edge(x, box.half_width) * edge(y, box.half_height) / (squared * squared);
    }
  return sum * (4.0 * box.half_width * box.half_height / (kSteps * kSteps));
}

Environment studio(double mean) {
  const auto grey = [mean](double times) { return glm::vec3(static_cast<float>(times * mean)); };
  Environment sky;
  sky.zenith = grey(0.1);
  sky.horizon = grey(2.0);
  sky.ground = grey(0.5);
  sky.backdrop = grey(2.0);
  sky.boxes = {soft_box({-0.8, 0.0, -0.6}, 0.7, 0.20, 0.13, 10.0f),
               soft_box({0.2, 0.0, -1.0}, 0.35, 0.045, 0.36, 10.0f),
               soft_box({1.0, 0.0, 0.15}, 0.45, 0.25, 0.20, 3.0f)};
  // The gradient gives a third of the horizon's radiance and two thirds of the zenith's (compose.md).
  const double left = mean * (1.0 - (2.0 + 2.0 * 0.1) / 3.0);
  double given = 0.0;
  for (const SoftBox& box : sky.boxes) given += box.radiance * upward_irradiance(box) / exact::kPi;
  for (SoftBox& box : sky.boxes) box.radiance = static_cast<float>(box.radiance * (left / given));
  sky.boxes_mean = static_cast<float>(left);
  return sky;
}

}  // namespace caustics
