// Smooth shading over sharp edges: normals that lead light astray inside glass.
#pragma once
#include "pipeline/scene/scene.hpp"

namespace caustics {

// By how much a mesh's normals lean away from its triangles: the mean over their corners, weighted by area,
// in radians. 0 without a triangle.
double mean_lean(const Mesh& mesh);

}  // namespace caustics
