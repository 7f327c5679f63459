#include "pipeline/scene/uv_density.hpp"

#include "pipeline/scene/exact.hpp"

namespace caustics {

std::vector<glm::vec2> uv_densities(const Mesh& mesh) {
  // Of each vertex: twice the area around it times the densities, and twice that area.
  std::vector<glm::dvec3> sums(mesh.vertices.size(), glm::dvec3(0.0));
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vertex& a = mesh.vertices[mesh.indices[i]];
    const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
    const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
    const glm::dvec3 along = glm::dvec3(b.position) - glm::dvec3(a.position);
    const glm::dvec3 across = glm::dvec3(c.position) - glm::dvec3(a.position);
    const glm::dvec2 to_b = glm::dvec2(b.uv) - glm::dvec2(a.uv), to_c = glm::dvec2(c.uv) - glm::dvec2(a.uv);
    // The gradient of u is n x (to_b.u across - to_c.u along) over twice the area.
    const glm::dvec3 sum(exact::length(across * to_b.x - along * to_c.x),
                         exact::length(across * to_b.y - along * to_c.y),
                         exact::length(exact::cross(along, across)));
    if (!exact::finite(sum)) continue;
    for (std::size_t corner = 0; corner < 3; ++corner) sums[mesh.indices[i + corner]] += sum;
  }
  std::vector<glm::vec2> densities;
  densities.reserve(sums.size());
  for (const glm::dvec3& sum : sums) {
    const glm::dvec2 density = sum.z > 0.0 ? glm::dvec2(sum.x, sum.y) / sum.z : glm::dvec2(0.0);
    densities.push_back(glm::vec2(glm::min(density, glm::dvec2(1e30))));
  }
  return densities;
}

}  // namespace caustics
