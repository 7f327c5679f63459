#include "lab/reference/tracer/exact_sphere.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics::tracer {

std::optional<ShapeMeeting> ExactSphere::nearest(const Ray& ray, double from, double to) const {
  const double a = exact::dot(ray.direction, ray.direction);
  // From the point of the ray that is nearest to the centre, so that a far origin costs no digits.
  const double middle = exact::dot(centre - ray.origin, ray.direction) / a;
  const glm::dvec3 across = ray.at(middle) - centre;
  const double squared = radius * radius - exact::dot(across, across);
  if (!(squared > 0.0)) return std::nullopt;
  const double half = std::sqrt(squared / a);
  for (const double t : {middle - half, middle + half}) {
    if (!(t >= from && t <= to)) continue;
    return ShapeMeeting{t, exact::normalise(ray.at(t) - centre, -ray.direction), t < middle};
  }
  return std::nullopt;
}

Bounds ExactSphere::bounds() const { return {centre - glm::dvec3(radius), centre + glm::dvec3(radius)}; }

void ExactSphere::append_numbers(std::vector<double>& numbers) const {
  numbers.insert(numbers.end(), {centre.x, centre.y, centre.z, radius});
}

ExactSphere sphere_of(const Mesh& mesh) {
  ExactSphere sphere{.centre = bounds_of(mesh).centre()};
  // The box of an even mesh has the sphere's middle; the farthest vertex has its radius, for none lies
  // beyond.
  double least = std::numeric_limits<double>::infinity();
  for (const Vertex& v : mesh.vertices) {
    const double distance = exact::length(glm::dvec3(v.position) - sphere.centre);
    sphere.radius = std::max(sphere.radius, distance);
    least = std::min(least, distance);
  }
  if (mesh.vertices.empty() || !(least >= 0.999 * sphere.radius) || !mesh.closed())
    throw Error(ExitCode::BadInput, "mesh '" + mesh.name +
                                        "' is no sphere: it must be closed, and its vertices lie on one to a "
                                        "thousandth");
  return sphere;
}

}  // namespace caustics::tracer
