#include "lab/reference/imagers.hpp"

#include <cmath>

namespace caustics {

double landing_towards_focus(double r, double z, double focus, double plane) {
  return r * (focus - plane) / (focus - z);
}

double EllipsoidalEntry::largest_radius() const { return focus * std::sqrt((index - 1.0) / (index + 1.0)); }

double EllipsoidalEntry::surface(double r) const {
  const double a = index * index - 1.0, b = index * (index - 1.0) * focus, nr = index * r;
  return nr * nr / (b + std::sqrt(b * b - a * nr * nr));
}

// The surface's equation differentiated: 2 n^2 r + 2 (n^2 - 1) z z' - 2 n (n - 1) F z' = 0.
double EllipsoidalEntry::slope(double r) const {
  const double a = index * index - 1.0, b = index * (index - 1.0) * focus;
  return index * index * r / (b - a * surface(r));
}

double EllipsoidalEntry::landing(double r, double plane) const {
  return landing_towards_focus(r, surface(r), focus, plane);
}

double ParaboloidMirror::landing(double r, double plane) const {
  return landing_towards_focus(r, surface(r), focus, plane);
}

}  // namespace caustics
