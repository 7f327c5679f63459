// How densely texture coordinates lie on a surface.
#pragma once
#include <vector>

#include "pipeline/scene/scene.hpp"

namespace caustics {

// By vertex: how fast u and v grow, per metre along their steepest directions; the mean over the triangles
// around it, weighted by area.
std::vector<glm::vec2> uv_densities(const Mesh& mesh);

}  // namespace caustics
