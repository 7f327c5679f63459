#include "pipeline/views/landing_window.hpp"

#include <algorithm>

namespace caustics {

namespace {

// Finer texels would show coordinates' rounding as grain.
constexpr double kRoundingsPerTexel = 8.0;
// Metres, or tangents: smaller ones have areas that irradiances in single precision cannot be divided by.
constexpr double kShortest = 1e-9;

}  // namespace

LandedFlux::LandedFlux(const std::vector<WeightedPoint>& points) {
  for (int axis = 0; axis < 2; ++axis) {
    along_[axis] = points;
    std::sort(along_[axis].begin(), along_[axis].end(),
              [axis](const WeightedPoint& a, const WeightedPoint& b) {
                if (a.window[axis] != b.window[axis]) return a.window[axis] < b.window[axis];
                return a.weight < b.weight;
              });
  }
  for (const WeightedPoint& p : along_[0]) {
    total_ += p.weight;
    if (p.weight > 0.0) rounding_ = std::max(rounding_, p.rounding);
  }
}

glm::dvec2 LandedFlux::range(int axis, double share) const {
  const std::vector<WeightedPoint>& points = along_[axis];
  double total = 0.0;
  for (const WeightedPoint& p : points) total += p.weight;
  std::size_t first = 0, last = points.size() - 1;
  for (double sum = points[first].weight; first < last && sum < share * total;) sum += points[++first].weight;
  for (double sum = points[last].weight; last > first && sum < share * total;) sum += points[--last].weight;
  const glm::dvec2 whole{points.front().window[axis], points.back().window[axis]};
  const glm::dvec2 cut{points[first].window[axis], points[last].window[axis]};
  return whole.y - whole.x < 1.2 * (cut.y - cut.x) ? whole : cut;
}

Window LandedFlux::window(double share) const {
  const glm::dvec2 x = range(0, share), y = range(1, share);
  return {{x.x, y.x}, {x.y, y.y}};
}

double LandedFlux::share_in(const Window& window) const {
  if (!(total_ > 0.0)) return 0.0;
  double inside = 0.0;
  for (const WeightedPoint& p : along_[0])
    if (window.holds(p.window)) inside += p.weight;
  return inside / total_;
}

double LandedFlux::shortest_side(int map) const {
  return std::max(kRoundingsPerTexel * rounding_ * map, kShortest);
}

void set_window(View& view, const Window& window, double margin, double shortest) {
  glm::dvec2 size = window.upper - window.lower;
  const glm::dvec2 centre = 0.5 * (window.lower + window.upper);
  size = glm::max(size, glm::dvec2(std::max(0.5 * std::max(size.x, size.y), shortest))) * (1.0 + margin);
  view.window_lower = centre - 0.5 * size;
  view.window_upper = centre + 0.5 * size;
}

}  // namespace caustics
