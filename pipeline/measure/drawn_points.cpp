#include "pipeline/measure/drawn_points.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/hierarchy_tables.hpp"

namespace caustics {

namespace {

double share(int number) { return (number + 0.5) / kPointsOfLamp; }

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

DrawnPoints::DrawnPoints(const Scene& scene, const Light& source) : source_(source) {
  if (source.is_lamp()) points_ = Emitter(scene, source.emitter).list(kPointsOfLamp);
}

glm::dvec3 DrawnPoints::start(const glm::dvec3& p, int number) const {
  if (!points_.empty()) return points_[static_cast<std::size_t>(number)].position;
  const glm::dvec2 drawn(share(number), share(number * 1936 % kPointsOfLamp));
  if (!source_.is_ball())
    return source_.position + source_.width * (drawn.x - 0.5) + source_.height * (drawn.y - 0.5);
  const glm::dvec3 facing = exact::normalise(p - source_.position, glm::dvec3(0.0, 0.0, 1.0));
  return source_.position + across(facing, on_disk(drawn) * source_.radius);
}

int DrawnPoints::number(int column, int row) {
  constexpr int n = kPointsOfLamp;
  return (column % n * 3681 % n + row % n * 2435 % n) % n * 117 % n;
}

bool DrawnPoints::has_place() const { return source_.shape != LightShape::Disk; }

double DrawnPoints::toward(const LightRay& ray, int column, int row) const {
  if (!points_.empty()) {
    const SurfacePoint& point = points_[static_cast<std::size_t>(number(column, row))];
    return std::max(exact::dot(point.normal, ray.direction), 0.0);
  }
  return source_.is_rectangle() ? std::max(exact::dot(source_.direction, ray.direction), 0.0) : 1.0;
}

LightRay DrawnPoints::ray(LightRay ray, const glm::dvec3& p, int column, int row) const {
  const int number = DrawnPoints::number(column, row);
  if (source_.shape == LightShape::Disk) {
    double sine, cosine;
    exact::sin_cos(source_.angular_radius, sine, cosine);
    const glm::dvec2 at = on_disk({share(number), share(number * 1936 % kPointsOfLamp)}) * (sine / cosine);
    ray.direction = exact::normalise(source_.direction + across(source_.direction, at), source_.direction);
    ray.origin = p - ray.direction * exact::dot(p - ray.origin, source_.direction);
    return ray;
  }
  ray.origin = start(p, number);
  ray.direction = exact::normalise(p - ray.origin, ray.direction);
  return ray;
}

}  // namespace caustics
