#include "pipeline/scene/scene.hpp"

namespace caustics {

Bounds bounds_of(const Mesh& mesh) {
  Bounds bounds;
  if (mesh.vertices.empty()) return bounds;
  bounds.add(glm::dvec3(mesh.lower));
  bounds.add(glm::dvec3(mesh.upper));
  return bounds;
}

Bounds bounds_of(const Scene& scene) {
  Bounds bounds;
  for (const Mesh& mesh : scene.meshes) bounds.add(bounds_of(mesh));
  return bounds;
}

}  // namespace caustics
