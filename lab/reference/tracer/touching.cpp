#include "lab/reference/tracer/touching.hpp"

#include <algorithm>
#include <map>

namespace caustics::tracer {

namespace {

bool is_solid(const Optics& optics) { return optics.role == Role::Refractor && optics.solid && !optics.thin; }

bool holds(const Bounds& bounds, const glm::dvec3& p, double margin) {
  for (int axis = 0; axis < 3; ++axis)
    if (p[axis] < bounds.lower[axis] - margin || p[axis] > bounds.upper[axis] + margin) return false;
  return true;
}

}  // namespace

std::unique_ptr<const Scene> with_overlaps(const Scene& scene, const std::vector<Optics>& optics, double by) {
  std::map<int, Bounds> bodies;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m)
    if (is_solid(optics[m])) bodies[optics[m].body].add(bounds_of(scene.meshes[m]));
  if (bodies.size() < 2) return nullptr;
  std::unique_ptr<Scene> grown;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    if (!is_solid(optics[m])) continue;
    for (std::size_t v = 0; v < scene.meshes[m].vertices.size(); ++v) {
      const Vertex& vertex = scene.meshes[m].vertices[v];
      const bool touches = std::any_of(bodies.begin(), bodies.end(), [&](const auto& other) {
        return other.first != optics[m].body && holds(other.second, glm::dvec3(vertex.position), by);
      });
      if (!touches) continue;
      if (!grown) grown = std::make_unique<Scene>(scene);
      grown->meshes[m].vertices[v].position += vertex.normal * static_cast<float>(by);
    }
  }
  return grown;
}

}  // namespace caustics::tracer
