// Which meshes bound one body, and what of a scene its triangles do not show.
#pragma once
#include <string>
#include <vector>

#include "pipeline/effects/effects.hpp"

namespace caustics {

// By Scene::meshes, whole numbers from 0: primitives of one object and material are one body.
std::vector<int> bodies_of(const Scene& scene);

// What in the scene following rays does not show: textures that cut holes, waves, haze. "textured panes
// (...)", with the reason; empty where it shows everything.
std::string not_in_triangles(const Scene& scene, const Effects& effects);

}  // namespace caustics
