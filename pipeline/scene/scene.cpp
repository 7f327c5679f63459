#include "pipeline/scene/scene.hpp"

namespace caustics {

const Light& source_of(const Scene& scene, int light) {
  const Light& drawn = scene.lights[static_cast<std::size_t>(light)];
  return drawn.source < 0 ? drawn : scene.sources[static_cast<std::size_t>(drawn.source)];
}

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
