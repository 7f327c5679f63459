#include "pipeline/measure/mesh_in_the_way.hpp"

#include <algorithm>
#include <numeric>

#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/triangle_tree.hpp"

namespace caustics {

namespace {

constexpr std::size_t kMostPoints = 64, kMostLights = 16;

// Centres of triangles, from all over the mesh.
std::vector<glm::dvec3> some_points(const Mesh& mesh) {
  std::vector<glm::dvec3> points;
  const std::size_t triangles = mesh.indices.size() / 3, step = triangles / kMostPoints + 1;
  for (std::size_t t = 0; t < triangles; t += step) {
    glm::dvec3 sum(0.0);
    for (std::size_t k = 0; k < 3; ++k) sum += glm::dvec3(mesh.vertices[mesh.indices[3 * t + k]].position);
    points.push_back(sum / 3.0);
  }
  return points;
}

// Metres that lie behind all of the scene, seen from any point of it.
double beyond(const Scene& scene) {
  glm::dvec3 lower(scene.meshes[0].lower), upper(scene.meshes[0].upper);
  for (const Mesh& mesh : scene.meshes) {
    lower = glm::min(lower, glm::dvec3(mesh.lower));
    upper = glm::max(upper, glm::dvec3(mesh.upper));
  }
  return 2.0 * exact::length(upper - lower) + 1e-6;
}

}  // namespace

int mesh_in_the_way(const Scene& scene, int caster) {
  std::vector<int> others(scene.meshes.size());
  std::iota(others.begin(), others.end(), 0);
  others.erase(others.begin() + caster);
  const TriangleTree tree(scene, others);
  const double far = beyond(scene);
  std::vector<int> met(scene.meshes.size());
  for (std::size_t l = 0; l < std::min(scene.lights.size(), kMostLights); ++l) {
    const Light& light = scene.lights[l];
    for (const glm::dvec3& point : some_points(scene.meshes[static_cast<std::size_t>(caster)])) {
      const glm::dvec3 from =
          light.type == LightType::Directional ? point - light.direction * far : light.position;
      const auto hit = tree.nearest(from, point - from, {}, light.emitter);
      if (hit && hit->distance < 1.0) ++met[static_cast<std::size_t>(hit->id.mesh)];
    }
  }
  const auto most = std::max_element(met.begin(), met.end());
  return *most > 0 ? static_cast<int>(most - met.begin()) : -1;
}

}  // namespace caustics
