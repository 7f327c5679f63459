// The floor that a whole ring of metal stands on: what its inner and its outer wall throw there. Metres.
#pragma once
#include "lab/reference/closed_forms.hpp"

namespace caustics {

// Upright around (0, 0) in plan view, under parallel light that travels along +x in plan view, `elevation`
// above the floor. First reflections only; none that passes through another part of the ring is taken out.
struct MetalRing {
  double inner = 0.5, outer = 0.54;  // radii
  double height = 0.2;
  double elevation = 0.7;    // radians
  double reflectance = 1.0;  // straight on; by Schlick (1994) at other angles
};

// Mean of E / E_perp over each pixel; rows from the lower corner on. Light that meets a wall at the angle t
// lands along a straight line of the floor (closed_forms.hpp: -(cos 2t, sin 2t)), evenly, as far as the wall
// is high; the inner wall is lit above the shadow of the rim across. Lines of `strips` angles, each divided
// exactly among the pixels that it crosses.
std::vector<double> irradiance_average(const MetalRing& ring, const FloorSquare& floor, int strips = 40'000);

}  // namespace caustics
