#include "app/output/color_scale.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace caustics::app {

Color cubehelix(double level) {
  const double angle = 2.0 * std::numbers::pi * (0.5 / 3.0 + 1.0 - 1.5 * level);
  const double amplitude = level * (1.0 - level) / 2.0;
  const double c = std::cos(angle), s = std::sin(angle);
  return {level + amplitude * (-0.14861 * c + 1.78277 * s), level + amplitude * (-0.29227 * c - 0.90649 * s),
          level + amplitude * 1.97294 * c};
}

Color logarithmic_color(double magnitude, double darkest, double largest) {
  constexpr double kDarkest = 0.1;
  if (!std::isfinite(magnitude)) return kFaultColor;
  if (magnitude == 0.0) return {0.0, 0.0, 0.0};
  if (magnitude >= largest) return cubehelix(1.0);
  const double level = 1.0 - (1.0 - kDarkest) * std::log(largest / magnitude) / std::log(largest / darkest);
  return cubehelix(std::max(level, kDarkest));
}

double darkest_of(double largest) { return 1e-6 * largest; }

}  // namespace caustics::app
