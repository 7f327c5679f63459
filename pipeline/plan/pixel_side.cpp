#include "pipeline/plan/pixel_side.hpp"

#include <algorithm>
#include <cmath>

namespace caustics {

namespace {

struct Texel {
  glm::dvec2 at{0.0};
  bool seen = false;
};

Texel texel_at(const Image& position, const Frame& frame, int map, int x, int y) {
  if (position.at(x, y, 3) == 0.0f) return {};
  const glm::dvec3 q = frame.coordinates({position.at(x, y, 0), position.at(x, y, 1), position.at(x, y, 2)});
  if (frame.perspective && !(q.z > 0.0)) return {};
  const glm::dvec2 share =
      (frame.window(q) - frame.window_lower) / (frame.window_upper - frame.window_lower);
  return {share * static_cast<double>(map), true};
}

double light_at(const Image& map, const glm::dvec2& texel) {
  const double x = std::floor(texel.x), y = std::floor(texel.y);
  if (!(x >= 0.0 && y >= 0.0 && x < map.width() && y < map.height())) return 0.0;
  double light = 0.0;
  for (int c = 0; c < std::min(map.channels(), 3); ++c)
    light += static_cast<double>(map.at(static_cast<int>(x), static_cast<int>(y), c));
  return light;
}

}  // namespace

double pixel_side(const Image& view_position, const Image& caustic_map, const Frame& caustic) {
  if (caustic.cube) return 0.0;
  double sides = 0.0, weights = 0.0;
  for (int y = 0; y + 1 < view_position.height(); ++y)
    for (int x = 0; x + 1 < view_position.width(); ++x) {
      const auto at = [&](int dx, int dy) {
        return texel_at(view_position, caustic, caustic_map.width(), x + dx, y + dy);
      };
      const Texel here = at(0, 0), right = at(1, 0), above = at(0, 1);
      if (!here.seen || !right.seen || !above.seen) continue;
      const double light = light_at(caustic_map, here.at);
      if (!(light > 0.0)) continue;
      const glm::dvec2 a = right.at - here.at, b = above.at - here.at;
      // The light in the pixel is in proportion to the light in the texel and to its area.
      const double area = std::fabs(a.x * b.y - a.y * b.x);
      sides += light * area * std::sqrt(area);
      weights += light * area;
    }
  return weights > 0.0 ? sides / weights : 0.0;
}

}  // namespace caustics
