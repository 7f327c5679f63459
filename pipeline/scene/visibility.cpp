#include "pipeline/scene/visibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace caustics {

namespace {

using BoxCorners = std::array<glm::dvec3, 8>;

// Share of the part's distance that rounding may hide.
constexpr double kSlack = 1e-6;

template <class At>
BoxCorners corners(const At& at) {
  BoxCorners result;
  for (int i = 0; i < 8; ++i) result[static_cast<std::size_t>(i)] = at(i & 1, i >> 1 & 1, i >> 2 & 1);
  return result;
}

// What a view sees is an intersection of half-spaces, a part the convex hull of its corners.
bool may_see(const View& view, const BoxCorners& part) {
  BoxCorners q;
  double size = 0.0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    q[i] = view.coordinates(part[i]);
    size = std::max({size, std::fabs(q[i].x), std::fabs(q[i].y), std::fabs(q[i].z)});
  }
  const double slack = kSlack * size;
  const auto all_beyond = [&](const auto& distance) {
    return std::all_of(q.begin(), q.end(), [&](const glm::dvec3& c) { return distance(c) > slack; });
  };
  const auto scale = [&](const glm::dvec3& c) { return view.perspective ? c.z : 1.0; };
  return !(all_beyond([&](const glm::dvec3& c) { return view.near - c.z; }) ||
           all_beyond([&](const glm::dvec3& c) { return c.z - view.far; }) ||
           all_beyond([&](const glm::dvec3& c) { return view.window_lower.x * scale(c) - c.x; }) ||
           all_beyond([&](const glm::dvec3& c) { return c.x - view.window_upper.x * scale(c); }) ||
           all_beyond([&](const glm::dvec3& c) { return view.window_lower.y * scale(c) - c.y; }) ||
           all_beyond([&](const glm::dvec3& c) { return c.y - view.window_upper.y * scale(c); }));
}

}  // namespace

bool may_see(const View& view, const Bounds& bounds) {
  if (bounds.empty()) return false;
  return may_see(view, corners([&](int x, int y, int z) {
                   return glm::dvec3(x ? bounds.upper.x : bounds.lower.x, y ? bounds.upper.y : bounds.lower.y,
                                     z ? bounds.upper.z : bounds.lower.z);
                 }));
}

bool may_see(const View& view, const View& other) {
  return may_see(
      view, corners([&](int x, int y, int z) {
        const double depth = z ? other.far : other.near;
        const double scale = other.perspective ? depth : 1.0;
        return other.origin + other.right * ((x ? other.window_upper.x : other.window_lower.x) * scale) +
               other.up * ((y ? other.window_upper.y : other.window_lower.y) * scale) + other.forward * depth;
      }));
}

}  // namespace caustics
