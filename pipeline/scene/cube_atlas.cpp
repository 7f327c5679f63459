#include "pipeline/scene/cube_atlas.hpp"

#include <cmath>

namespace caustics {

glm::dvec3 turned_to_face(const glm::dvec3& q, int face) {
  switch (face) {
    case 0:
      return {-q.z, q.y, q.x};
    case 1:
      return {q.z, q.y, -q.x};
    case 2:
      return {q.x, -q.z, q.y};
    case 3:
      return {q.x, q.z, -q.y};
    case 4:
      return q;
    default:
      return {-q.x, q.y, -q.z};
  }
}

glm::dvec3 turned_from_face(const glm::dvec3& q, int face) {
  // Opposite sides' turns undo one another; ahead and behind undo themselves.
  return turned_to_face(q, face < 4 ? face ^ 1 : face);
}

int face_of(const glm::dvec3& q) {
  const double x = std::fabs(q.x), y = std::fabs(q.y), z = std::fabs(q.z);
  if (z >= x && z >= y) return q.z >= 0.0 ? 4 : 5;
  if (x >= y) return q.x >= 0.0 ? 0 : 1;
  return q.y >= 0.0 ? 2 : 3;
}

}  // namespace caustics
