#include "lab/reference/ring_floor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace caustics {

namespace {

// A straight line of light on the floor.
struct Line {
  glm::dvec2 start{0.0}, direction{0.0};  // unit
  double from = 0.0, to = 0.0;            // metres along it
  double density = 0.0;                   // of flux, per metre
};

class Pixels {
 public:
  explicit Pixels(const FloorSquare& floor)
      : floor_(floor),
        pixel_(floor.side / floor.pixels),
        flux_(static_cast<std::size_t>(floor.pixels) * static_cast<std::size_t>(floor.pixels)) {}

  // From one border between pixels to the next.
  void add(const Line& line) {
    double s = line.from;
    while (s < line.to) {
      const double next = std::min({border(line, 0, s), border(line, 1, s), line.to});
      const glm::dvec2 middle = line.start + line.direction * (0.5 * (s + next));
      const glm::dvec2 at = glm::floor((middle - floor_.lower) / pixel_);
      if (at.x >= 0.0 && at.y >= 0.0 && at.x < floor_.pixels && at.y < floor_.pixels)
        flux_[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(floor_.pixels) +
              static_cast<std::size_t>(at.x)] += line.density * (next - s);
      s = next;
    }
  }

  std::vector<double> means() {
    for (double& value : flux_) value /= pixel_ * pixel_;
    return std::move(flux_);
  }

 private:
  // The next place behind s where the line crosses a border across this axis. A step behind the last one, so
  // that rounding does not stop there.
  double border(const Line& line, int axis, double s) const {
    const double slope = line.direction[axis];
    if (slope == 0.0) return std::numeric_limits<double>::infinity();
    const double behind = s + 1e-9 * pixel_;
    const double place = (line.start[axis] + slope * behind - floor_.lower[axis]) / pixel_;
    const double wall = slope > 0.0 ? std::floor(place) + 1.0 : std::ceil(place) - 1.0;
    return std::max((floor_.lower[axis] + wall * pixel_ - line.start[axis]) / slope, behind);
  }

  FloorSquare floor_;
  double pixel_;
  std::vector<double> flux_;
};

double schlick(double straight_on, double cosine) {
  return straight_on + (1.0 - straight_on) * std::pow(1.0 - cosine, 5.0);
}

}  // namespace

// The wall's strip R dt of height dh takes cos(elevation) |cos t| R dt dh; its light lands ds = dh
// cot(elevation) farther.
std::vector<double> irradiance_average(const MetalRing& ring, const FloorSquare& floor, int strips) {
  Pixels pixels(floor);
  const double reach = ring.height / std::tan(ring.elevation);
  const double dt = std::numbers::pi / strips;
  for (int i = 0; i < strips; ++i)
    for (const bool inside : {true, false}) {
      const double t = (inside ? -0.5 : 0.5) * std::numbers::pi + (i + 0.5) * dt;
      const double radius = inside ? ring.inner : ring.outer, facing = std::fabs(std::cos(t));
      Line line{.start = radius * glm::dvec2(std::cos(t), std::sin(t)),
                .direction = -glm::dvec2(std::cos(2.0 * t), std::sin(2.0 * t)),
                .to = reach};
      // The rim across, a chord away, shadows what is lower.
      if (inside) line.from = std::max(reach - 2.0 * radius * facing, 0.0);
      line.density = schlick(ring.reflectance, std::cos(ring.elevation) * facing) * std::sin(ring.elevation) *
                     radius * facing * dt;
      pixels.add(line);
    }
  return pixels.means();
}

}  // namespace caustics
