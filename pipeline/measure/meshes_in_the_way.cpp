#include "pipeline/measure/meshes_in_the_way.hpp"

#include <algorithm>
#include <numeric>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

constexpr std::size_t kMostPoints = 64, kMostLights = 16;

std::vector<int> all_meshes(const Scene& scene) {
  std::vector<int> meshes(scene.meshes.size());
  std::iota(meshes.begin(), meshes.end(), 0);
  return meshes;
}

}  // namespace

std::vector<glm::dvec3> some_points(const Mesh& mesh, std::size_t most) {
  std::vector<glm::dvec3> points;
  const std::size_t triangles = mesh.indices.size() / 3, step = triangles / most + 1;
  for (std::size_t t = 0; t < triangles; t += step) {
    glm::dvec3 sum(0.0);
    for (std::size_t k = 0; k < 3; ++k) sum += glm::dvec3(mesh.vertices[mesh.indices[3 * t + k]].position);
    points.push_back(sum / 3.0);
  }
  return points;
}

MeshesInTheWay::MeshesInTheWay(const Scene& scene)
    : scene_(scene), tree_(scene, all_meshes(scene)), beyond_(4.0 * bounds_of(scene).radius() + 1e-6) {}

glm::dvec3 MeshesInTheWay::origin(const Light& light, const glm::dvec3& point) const {
  return light.type == LightType::Directional ? point - light.direction * beyond_ : light.position;
}

bool MeshesInTheWay::stands_opaque(const Effects& effects, const Light& light,
                                   const glm::dvec3& point) const {
  glm::dvec3 from = origin(light, point);
  TriangleId last;
  // Through panes and casters; what lies behind more of them counts as hidden.
  for (int met = 0; met < 8; ++met) {
    const auto hit = tree_.nearest(from, point - from, last, light.emitter);
    if (!hit || !(hit->distance < 1.0 - 1e-6)) return false;
    if (effects.surfaces[static_cast<std::size_t>(hit->id.mesh)].role == Role::Receiver) return true;
    last = hit->id;
    from += (point - from) * hit->distance;
  }
  return true;
}

int MeshesInTheWay::before(int caster, const std::vector<int>& lights) const {
  const std::vector<glm::dvec3> points =
      some_points(scene_.meshes[static_cast<std::size_t>(caster)], kMostPoints);
  std::vector<int> met(scene_.meshes.size());
  for (std::size_t l = 0; l < std::min(lights.size(), kMostLights); ++l) {
    const Light& light = scene_.lights[static_cast<std::size_t>(lights[l])];
    for (const glm::dvec3& point : points) {
      const glm::dvec3 from = origin(light, point);
      const auto hit = tree_.nearest(from, point - from, {}, light.emitter);
      if (hit && hit->distance < 1.0 && hit->id.mesh != caster) ++met[static_cast<std::size_t>(hit->id.mesh)];
    }
  }
  const auto most = std::max_element(met.begin(), met.end());
  return most != met.end() && *most > 0 ? static_cast<int>(most - met.begin()) : -1;
}

}  // namespace caustics
