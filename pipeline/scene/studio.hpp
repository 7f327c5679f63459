// The light of a studio, for scenes that bring no light from all around.
#pragma once
#include "pipeline/scene/scene.hpp"

namespace caustics {

// Grey, brightest at the horizon, with a key light high behind on the left, a strip behind on the right and a
// weak light before on the right, of a camera that looks along (-0.6, 0, -0.8). A surface that faces up gets
// pi times `mean`, nit.
Environment studio(double mean);

// What a soft box gives a surface that faces up, over its radiance.
double upward_irradiance(const SoftBox& box);

}  // namespace caustics
