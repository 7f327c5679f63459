// Windows of a light's views that hold most of the flux that landed.
#pragma once
#include <vector>

#include "pipeline/scene/view.hpp"

namespace caustics {

// A landing in window coordinates, and its flux in any unit.
struct WeightedPoint {
  glm::dvec2 window{0.0};
  double weight = 0.0;
  double rounding = 0.0;  // what single precision may move it by, in window coordinates
};

struct Window {
  glm::dvec2 lower{0.0}, upper{0.0};
  double area() const { return (upper.x - lower.x) * (upper.y - lower.y); }
  bool holds(const glm::dvec2& p) const {
    return p.x >= lower.x && p.x <= upper.x && p.y >= lower.y && p.y <= upper.y;
  }
};

class LandedFlux {
 public:
  // At least one point. Their order does not matter.
  explicit LandedFlux(const std::vector<WeightedPoint>& points);
  // Leaves out at most `share` of the flux at each end of each axis; along an axis where that hardly saves
  // anything, none.
  Window window(double share) const;
  // The share of all flux in a window, 0..1.
  double share_in(const Window& window) const;
  // The side of the smallest window that is worth a map of so many texels a side: its texels are some
  // roundings wide.
  double shortest_side(int map) const;

 private:
  glm::dvec2 range(int axis, double share) const;

  std::vector<WeightedPoint> along_[2];  // sorted by x, and by y
  double total_ = 0.0, rounding_ = 0.0;
};

// Gives a view this window and a margin, a share of its size. No side becomes shorter than half the other,
// so that texels stay compact, or than `shortest`.
void set_window(View& view, const Window& window, double margin, double shortest = 1e-9);

}  // namespace caustics
