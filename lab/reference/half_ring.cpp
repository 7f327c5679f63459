#include "lab/reference/half_ring.hpp"

#include <cmath>
#include <numbers>

namespace caustics {

glm::dvec2 HalfRing::landing(double t, double s) const {
  return glm::dvec2(radius * std::cos(t) - s * std::cos(2.0 * t),
                    radius * std::sin(t) - s * std::sin(2.0 * t));
}

// The wall's strip dt takes a strip of light R cos t dt wide, and what lands ds farther lies ds
// higher on the wall: the floor gets R cos t dt ds of its direct light.
std::vector<double> irradiance_average(const HalfRing& ring, const FloorSquare& floor, int samples) {
  const double pixel = floor.side / floor.pixels, fine = pixel / samples;
  const double arc = ring.radius + 2.0 * ring.reach;  // at most d landing / dt
  const int across = static_cast<int>(std::ceil(std::numbers::pi * arc / fine));
  const int along = static_cast<int>(std::ceil(ring.reach / fine));
  const double dt = std::numbers::pi / across, ds = ring.reach / along;
  std::vector<double> values(static_cast<std::size_t>(floor.pixels) * static_cast<std::size_t>(floor.pixels));
  for (int i = 0; i < across; ++i) {
    const double t = -0.5 * std::numbers::pi + (i + 0.5) * dt;
    const double share = ring.reflectance * ring.radius * std::cos(t) * dt * ds / (pixel * pixel);
    const glm::dvec2 wall = (ring.landing(t, 0.0) - floor.lower) / pixel;
    const glm::dvec2 step = (ring.landing(t, ds) - ring.landing(t, 0.0)) / pixel;
    for (int k = 0; k < along; ++k) {
      const glm::dvec2 p = wall + (k + 0.5) * step;
      if (p.x < 0.0 || p.y < 0.0 || p.x >= floor.pixels || p.y >= floor.pixels) continue;
      values[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(floor.pixels) +
             static_cast<std::size_t>(p.x)] += share;
    }
  }
  return values;
}

}  // namespace caustics
