#include "pipeline/measure/leaning_normals.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"

namespace caustics {

double mean_lean(const Mesh& mesh) {
  double sum = 0.0, area = 0.0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vertex* corners[3];
    for (std::size_t k = 0; k < 3; ++k) corners[k] = &mesh.vertices[mesh.indices[i + k]];
    const glm::dvec3 origin(corners[0]->position);
    const glm::dvec3 across =
        exact::cross(glm::dvec3(corners[1]->position) - origin, glm::dvec3(corners[2]->position) - origin);
    const double weight = exact::length(across);
    if (!(weight > 0.0)) continue;
    area += weight;
    for (const Vertex* corner : corners) {
      const double along = exact::dot(across, glm::dvec3(corner->normal)) / weight;
      sum += weight / 3.0 * std::acos(std::clamp(along, -1.0, 1.0));
    }
  }
  return area > 0.0 ? sum / area : 0.0;
}

}  // namespace caustics
