#include "pipeline/measure/drawn_points.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

constexpr int kModulus = 4093;

double share(int number) { return (number + 0.5) / kModulus; }

double wave(double x) {
  const double t = 2.0 * (x - std::floor(x));
  return t < 1.0 ? t * (1.0 - t) : (t - 1.0) * (t - 2.0);
}

glm::dvec2 on_disk(const glm::dvec2& drawn) {
  const glm::dvec2 way(wave(drawn.y + 0.25), wave(drawn.y));
  return way * std::sqrt(drawn.x / (way.x * way.x + way.y * way.y));
}

// Along the axes across a direction (passes/shared/axes_across.glsl).
glm::dvec3 across(const glm::dvec3& d, const glm::dvec2& at) {
  const double sign = d.z >= 0.0 ? 1.0 : -1.0, a = -1.0 / (sign + d.z), b = d.x * d.y * a;
  const glm::dvec3 x(1.0 + sign * d.x * d.x * a, sign * b, -sign * d.x), y(b, sign + d.y * d.y * a, -d.y);
  return x * at.x + y * at.y;
}

}  // namespace

LightRay from_own_point(const Light& source, LightRay ray, const glm::dvec3& p, int column, int row) {
  const int first =
      (column % kModulus * 3681 % kModulus + row % kModulus * 2435 % kModulus) % kModulus * 117 % kModulus;
  const glm::dvec2 drawn(share(first), share(first * 1936 % kModulus));
  if (source.shape == LightShape::Disk) {
    double sine, cosine;
    exact::sin_cos(source.angular_radius, sine, cosine);
    const glm::dvec3 direction = exact::normalise(
        source.direction + across(source.direction, on_disk(drawn)) * (sine / cosine), source.direction);
    ray.origin = p - direction * exact::dot(p - ray.origin, source.direction);
    ray.direction = direction;
    return ray;
  }
  const glm::dvec3 facing = exact::normalise(p - source.position, glm::dvec3(0.0, 0.0, 1.0));
  ray.origin = source.position;
  ray.origin += source.is_ball() ? across(facing, on_disk(drawn) * source.radius)
                                 : source.width * (drawn.x - 0.5) + source.height * (drawn.y - 0.5);
  ray.direction = exact::normalise(p - ray.origin, ray.direction);
  return ray;
}

}  // namespace caustics
