// The floor inside a half ring of metal, counted: what the closed form of one ray
// (closed_forms.hpp) adds up to over all rays that reach a pixel.
#pragma once
#include "lab/reference/closed_forms.hpp"

namespace caustics {

// A vertical half cylinder round (0, 0) in plan view, x > 0, lit from inside along +x. Metres.
// First reflections only, and none that pass through another part of the wall are taken out.
struct HalfRing {
  double radius = 1.0;
  double reach = 0.5;  // of light in plan view from the wall to the floor: height * cot(elevation)
  double reflectance = 1.0;

  // Where the ray that meets the wall at the angle t lands after s metres in plan view.
  glm::dvec2 landing(double t, double s) const;
};

// Mean over each pixel, relative to the floor's direct light; rows from the lower corner on.
// `samples`: rays to a pixel's side.
std::vector<double> irradiance_average(const HalfRing& ring, const FloorSquare& floor, int samples = 16);

}  // namespace caustics
