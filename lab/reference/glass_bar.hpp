// Flat-sided glass with one cross-section along its length, such as a prism or a slab, under parallel light
// across that length: what falls on the floor, exactly. Metres.
#pragma once
#include "lab/reference/closed_forms.hpp"

namespace caustics {

struct GlassBar {
  std::vector<glm::dvec2>
      corners{};             // of the convex cross-section: x and height above the floor, counter-clockwise
  double half_length = 1.0;  // along the third axis, to both sides of 0
  glm::dvec2 travel{0.0, -1.0};  // unit, the way of the light; downwards
  double index = 1.5;
};

// Mean of E / E_perp over each pixel of the floor; the square's second coordinate runs along the bar. Light
// that enters by one side and leaves by the next one that it meets, both by Snell's law and with what
// Fresnel's equations pass; what is totally reflected there does not come. Between flat sides parallel light
// stays parallel: each pair of sides lights one rectangle of the floor evenly.
std::vector<double> irradiance_average(const GlassBar& bar, const FloorSquare& floor);

}  // namespace caustics
