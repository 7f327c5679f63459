// Lights with a size whose caustic is drawn once: each grid vertex sends on light from a point of its own.
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// After with_dim_lights. Where light can be followed from surface to surface, of each light with a size and
// several samples the first, nearest its middle, throws the caustic of all, and its view of the casters is
// the grid: what it does not see of them gets no light. All give their own direct light. A mesh that shines
// keeps a caustic a sample.
Effects with_drawn_sizes(Effects effects, const Scene& scene, const Settings& settings);

// Is any light drawn so?
bool any_size_is_drawn(const Effects& effects);
// Is every light that throws a caustic?
bool all_sizes_are_drawn(const Effects& effects);

}  // namespace caustics
