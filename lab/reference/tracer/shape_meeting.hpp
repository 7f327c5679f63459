// Where a ray meets an exact shape.
#pragma once
#include <glm/glm.hpp>

namespace caustics::tracer {

struct ShapeMeeting {
  double distance = 0.0;   // in lengths of the ray's direction
  glm::dvec3 normal{0.0};  // unit, outward
  bool front = true;       // the ray comes from the outer side
};

}  // namespace caustics::tracer
