// A ray of light or of sight.
#pragma once
#include <glm/glm.hpp>

namespace caustics::tracer {

// Origin and direction in scene space, metres; distances are in lengths of `direction`.
struct Ray {
  glm::dvec3 origin{0.0}, direction{0.0, 0.0, -1.0};
  glm::dvec3 at(double distance) const { return origin + direction * distance; }
};

}  // namespace caustics::tracer
