#include "lab/reference/tracer/exact_cylinder.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"

namespace caustics::tracer {

namespace {

// Keeps the nearest of several meetings.
void keep(std::optional<ShapeMeeting>& best, double t, const glm::dvec3& normal,
          const glm::dvec3& direction) {
  if (best && best->distance <= t) return;
  best = ShapeMeeting{t, normal, exact::dot(normal, direction) < 0.0};
}

}  // namespace

std::optional<ShapeMeeting> ExactCylinder::nearest(const Ray& ray, double from, double to) const {
  std::optional<ShapeMeeting> best;
  const double along = exact::dot(ray.direction, axis);
  const glm::dvec3 sideways = ray.direction - axis * along;
  const double a = exact::dot(sideways, sideways);
  const glm::dvec3 start = ray.origin - foot;
  // From the point of the ray that is nearest to the axis, so that a far origin costs no digits.
  const double middle_t = a > 0.0 ? -exact::dot(start, sideways) / a : 0.0;
  const auto from_axis = [&](double t) {
    const glm::dvec3 p = ray.at(t) - foot;
    return p - axis * exact::dot(p, axis);
  };
  const glm::dvec3 across = from_axis(middle_t);
  for (const Wall& wall : walls) {
    const double squared = wall.radius * wall.radius - exact::dot(across, across);
    if (!(a > 0.0 && squared > 0.0)) continue;
    const double half = std::sqrt(squared / a);
    for (const double t : {middle_t - half, middle_t + half}) {
      if (!(t >= from && t <= to)) continue;
      const double h = exact::dot(ray.at(t) - foot, axis);
      if (!(h >= 0.0 && h <= height)) continue;
      const glm::dvec3 radial = exact::normalise(from_axis(t), middle);
      if (exact::dot(radial, middle) < least_cosine) continue;
      keep(best, t, radial * wall.outward, ray.direction);
    }
  }
  const double inner = walls.size() > 1 ? walls[1].radius : 0.0, outer = walls[0].radius;
  for (const bool upper : {false, true}) {
    if (!(upper ? upper_lid : lower_lid) || along == 0.0) continue;
    const double t = ((upper ? height : 0.0) - exact::dot(start, axis)) / along;
    if (!(t >= from && t <= to)) continue;
    const glm::dvec3 q = from_axis(t);
    const double squared = exact::dot(q, q);
    if (squared >= inner * inner && squared <= outer * outer)
      keep(best, t, upper ? axis : -axis, ray.direction);
  }
  return best;
}

Bounds ExactCylinder::bounds() const {
  Bounds bounds;
  const glm::dvec3 one(1.0);
  const glm::dvec3 reach = walls[0].radius * glm::sqrt(glm::max(one - axis * axis, glm::dvec3(0.0)));
  for (const glm::dvec3& end : {foot, foot + axis * height}) {
    bounds.add(end - reach);
    bounds.add(end + reach);
  }
  return bounds;
}

void ExactCylinder::append_numbers(std::vector<double>& numbers) const {
  for (const glm::dvec3& v : {foot, axis, middle}) numbers.insert(numbers.end(), {v.x, v.y, v.z});
  for (const Wall& wall : walls) numbers.insert(numbers.end(), {wall.radius, wall.outward});
  numbers.insert(numbers.end(), {height, least_cosine, lower_lid ? 1.0 : 0.0, upper_lid ? 1.0 : 0.0});
}

}  // namespace caustics::tracer
