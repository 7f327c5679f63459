#include "pipeline/measure/surface_steps.hpp"

namespace caustics {

std::optional<glm::dvec3> surface_at(const ImageView& position, int x, int y) {
  if (x < 0 || y < 0 || x >= position.width() || y >= position.height() || position.at(x, y, 3) == 0.0f)
    return {};
  return glm::dvec3(position.at(x, y, 0), position.at(x, y, 1), position.at(x, y, 2));
}

std::optional<glm::dvec3> surface_step(const ImageView& position, const glm::dvec3& here, int x, int y,
                                       int dx, int dy) {
  const auto ahead = surface_at(position, x + dx, y + dy), behind = surface_at(position, x - dx, y - dy);
  if (!ahead && !behind) return {};
  if (!behind || (ahead && glm::distance(*ahead, here) <= glm::distance(*behind, here))) return *ahead - here;
  return here - *behind;
}

}  // namespace caustics
