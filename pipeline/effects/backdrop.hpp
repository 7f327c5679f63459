// Surfaces that cannot throw a shadow.
#pragma once
#include <cstddef>

#include "pipeline/effects/effects.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics {

// A flat mesh that has every other mesh on its lit side, such as a floor below everything, throws no
// shadow on anything. `mesh` is an index into Scene::meshes.
bool is_backdrop(const Scene& scene, std::size_t mesh, const Light& light);

// Do all receivers lie in one plane? A receiver map of any resolution is exact then.
bool receivers_are_one_plane(const Scene& scene, const Effects& effects);

}  // namespace caustics
