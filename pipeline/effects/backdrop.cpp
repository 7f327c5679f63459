#include "pipeline/effects/backdrop.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"

namespace caustics {

bool is_backdrop(const Scene& scene, std::size_t index, const Light& light) {
  const Mesh& mesh = scene.meshes[index];
  if (mesh.vertices.empty()) return true;
  const glm::dvec3 point{mesh.vertices[0].position};
  glm::dvec3 normal{mesh.vertices[0].normal};
  const double flat = 1e-4 * std::max(bounds_of(scene).radius(), 1e-30);
  for (const Vertex& v : mesh.vertices)
    if (std::fabs(exact::dot(glm::dvec3(v.position) - point, normal)) > flat) return false;
  const bool directional = light.type == LightType::Directional;
  const double facing = exact::dot(normal, directional ? light.direction : point - light.position);
  if (facing > 0.0) normal = -normal;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (i == index) continue;
    for (const Vertex& v : scene.meshes[i].vertices)
      if (exact::dot(glm::dvec3(v.position) - point, normal) < -flat) return false;
  }
  return true;
}

bool receivers_are_one_plane(const Scene& scene, const Effects& effects) {
  const Vertex* first = nullptr;
  const double flat = 1e-4 * std::max(bounds_of(scene).radius(), 1e-30);
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (effects.surfaces[i].role != Role::Receiver) continue;
    for (const Vertex& v : scene.meshes[i].vertices) {
      if (!first) first = &v;
      const glm::dvec3 from_first = glm::dvec3(v.position) - glm::dvec3(first->position);
      if (std::fabs(exact::dot(from_first, glm::dvec3(first->normal))) > flat) return false;
    }
  }
  return true;
}

}  // namespace caustics
