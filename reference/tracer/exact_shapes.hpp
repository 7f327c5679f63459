// Shapes that a mesh stands for, traced in its place: no facets.
#pragma once
#include <optional>
#include <string>

#include "pipeline/scene/scene.hpp"

namespace caustics::tracer {

struct ExactSphere {
  int mesh = -1;  // of Scene::meshes, that it takes the place of
  glm::dvec3 centre{0.0};
  double radius = 0.0;  // metres

  // Distances at which the ray meets it, in lengths of `direction`; the two are equal where it grazes or just misses.
  struct Meetings {
    double first, second;
    bool real;  // false: it passes by
  };
  Meetings meetings(const glm::dvec3& origin, const glm::dvec3& direction) const;
};

// The sphere of a mesh, all of whose vertices lie on it to a thousandth of its radius and all around it. Throws
// Error (BadInput) naming the mesh where they do not.
ExactSphere sphere_of(const Scene& scene, int mesh);

}  // namespace caustics::tracer
