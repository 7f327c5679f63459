// A picture of the floor under a glass sphere held against the closed form.
#pragma once
#include <vector>

#include "lab/reference/closed_forms.hpp"

namespace caustics {

struct SphereFloorError {
  double relative_l1_in_shadow =
      0.0;                  // sum |difference| over the sum of the truth, pixels wholly in the shadow
  double flux_ratio = 0.0;  // picture over truth, the whole square
  double dark_share = 0.0;  // of those pixels: lit by the truth, without any light in the picture
};

// `picture`: irradiance in lux of square pixels over the square of `side` metres whose middle lies under the
// sphere's centre, by any rows (the sphere is round). Light of 1 lux straight down; outside the shadow it
// adds 1.
SphereFloorError compare_with_sphere(const std::vector<double>& picture, const GlassSphere& sphere,
                                     double side);

}  // namespace caustics
