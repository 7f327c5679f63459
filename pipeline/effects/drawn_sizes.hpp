// Lights with a size whose caustic is drawn once: each grid vertex sends on light from a point of its own.
#pragma once
#include <set>

#include "pipeline/effects/effects.hpp"

namespace caustics {

// Returns the casters that a light throws caustics through, indices into Scene::meshes.
std::set<int> casters_of(const Effects& effects, int light);

// After with_dim_lights. Where light can be followed from surface to surface, of each light with a size and
// several samples one throws the caustic of all: the nearest to its middle, of a mesh the one that faces the
// casters most. Its view of the casters is the grid: what it does not see of them gets no light. All give
// their own direct light, with smaller shadow maps where the light looks wide. A mesh that has no sample with
// all casters before it keeps a caustic a sample.
Effects with_drawn_sizes(Effects effects, const Scene& scene, const Settings& settings);

// Is any light drawn so?
bool any_size_is_drawn(const Effects& effects);
// Is every light that throws a caustic?
bool all_sizes_are_drawn(const Effects& effects);

}  // namespace caustics
