// Which meshes bound one body.
#pragma once
#include <vector>

#include "pipeline/effects/effects.hpp"

namespace caustics {

// By Scene::meshes, whole numbers from 0: primitives of one object and material are one body.
std::vector<int> bodies_of(const Scene& scene);

}  // namespace caustics
