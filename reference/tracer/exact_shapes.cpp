#include "reference/tracer/exact_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics::tracer {

ExactSphere::Meetings ExactSphere::meetings(const glm::dvec3& origin, const glm::dvec3& direction) const {
  const double a = exact::dot(direction, direction);
  // From the point of the ray that is nearest to the centre, so that a far origin costs no digits.
  const double nearest = exact::dot(centre - origin, direction) / a;
  const glm::dvec3 across = origin + direction * nearest - centre;
  const double squared = radius * radius - exact::dot(across, across);
  const double half = std::sqrt(std::max(squared, 0.0) / a);
  return {nearest - half, nearest + half, squared > 0.0};
}

ExactSphere sphere_of(const Scene& scene, int mesh) {
  const Mesh& m = scene.meshes[static_cast<std::size_t>(mesh)];
  const Bounds box = bounds_of(m);
  ExactSphere sphere{.mesh = mesh, .centre = box.centre()};
  // The box of an even mesh has the sphere's middle; the farthest vertex has its radius, for none lies beyond.
  double least = std::numeric_limits<double>::infinity();
  for (const Vertex& v : m.vertices) {
    const double distance = exact::length(glm::dvec3(v.position) - sphere.centre);
    sphere.radius = std::max(sphere.radius, distance);
    least = std::min(least, distance);
  }
  if (m.vertices.empty() || !(least >= 0.999 * sphere.radius) || !m.closed())
    throw Error(ExitCode::BadInput, "mesh '" + m.name + "' is no sphere: it must be closed, and its vertices lie on one to a thousandth");
  return sphere;
}

}  // namespace caustics::tracer
