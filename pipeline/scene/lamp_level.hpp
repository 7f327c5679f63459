// How bright it is where most of the lamps' light arrives: what a scene without a subject is exposed for.
#pragma once
#include "pipeline/scene/scene.hpp"

namespace caustics {

// In lux: a quarter of the light of all lights with a position falls where one of them (all samples of one
// with a size) makes it at least as bright, on opaque surfaces without glass and mirrors; found by a few
// thousand rays. 0 where no light falls on any.
double lamp_level(const Scene& scene);

}  // namespace caustics
