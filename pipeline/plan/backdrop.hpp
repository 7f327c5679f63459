// Surfaces that cannot throw a shadow.
#pragma once
#include <cstddef>

#include "pipeline/scene/scene.hpp"

namespace caustics {

// A flat mesh that has every other mesh on its lit side, such as a floor below everything, throws no
// shadow on anything. `mesh` is an index into Scene::meshes.
bool is_backdrop(const Scene& scene, std::size_t mesh, const Light& light);

}  // namespace caustics
