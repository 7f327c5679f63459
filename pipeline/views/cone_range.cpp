#include "pipeline/views/cone_range.hpp"

#include <cmath>

#include "pipeline/scene/exact.hpp"

namespace caustics {

std::optional<glm::dvec2> cone_range(const View& axes, int axis, const glm::dvec3& direction,
                                     double half_angle) {
  double sine, cosine;
  exact::sin_cos(half_angle, sine, cosine);
  const double across = exact::dot(direction, axis == 0 ? axes.right : axes.up);
  const double along = exact::dot(direction, axes.forward);
  // A plane along the other axis touches the cone at the angle whose sine is `sine` over the projected axis'
  // length.
  const double squared = across * across + along * along - sine * sine;
  if (!(cosine > 0.0) || !(along > 0.0) || !(squared > 0.0)) return {};
  const double middle = across / along, half = sine / std::sqrt(squared);
  if (!(std::fabs(middle * half) < 0.99)) return {};
  return glm::dvec2((middle - half) / (1.0 + middle * half), (middle + half) / (1.0 - middle * half));
}

}  // namespace caustics
