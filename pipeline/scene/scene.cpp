#include "pipeline/scene/scene.hpp"

#include <algorithm>

namespace caustics {

double brightness(const Light& light) {
  return static_cast<double>(light.intensity) *
         static_cast<double>(std::max({light.color.x, light.color.y, light.color.z}));
}

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

Bounds medium_bounds(const Scene& scene) {
  Bounds bounds = bounds_of(scene);
  for (const Camera& camera : scene.cameras) bounds.add(camera.position);
  for (const Light& light : scene.lights)
    if (light.type != LightType::Directional) bounds.add(light.position);
  return bounds;
}

}  // namespace caustics
