// Surfaces without aberration: parallel light along their axis meets in one point, exactly. Double
// precision, metres. With the hyperbolic exit face (closed_forms.hpp) the sharpest truths there
// are: whatever a rendering adds to the point comes from its own resolution.
//
// Each is the set of points of equal optical path between a plane across the light and the focus
// (Descartes' ovals at infinity). z along the axis, r from it, the vertex at z = 0.
#pragma once
#include <glm/glm.hpp>

namespace caustics {

// Where a ray through the focus, coming from (r, z), meets the plane: signed, negative beyond the
// axis.
double landing_towards_focus(double r, double z, double focus, double plane);

// Light along +z enters glass through an ellipsoid and meets at z = focus inside:
// n^2 r^2 + (n^2 - 1) z^2 - 2 n (n - 1) F z = 0.
struct EllipsoidalEntry {
  double index = 1.5;
  double focus = 1.0;
  double largest_radius() const;   // beyond it there is no entry face: F sqrt((n - 1) / (n + 1))
  double surface(double r) const;  // z >= 0
  double slope(double r) const;    // dz / dr
  double landing(double r, double plane) const;
};

// Light along -z meets the paraboloid z = r^2 / (4 F) and is mirrored to z = focus.
struct ParaboloidMirror {
  double focus = 1.0;
  double surface(double r) const { return r * r / (4.0 * focus); }
  double slope(double r) const { return r / (2.0 * focus); }
  double landing(double r, double plane) const;
};

}  // namespace caustics
