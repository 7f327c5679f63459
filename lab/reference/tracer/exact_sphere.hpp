// A sphere in place of its mesh.
#pragma once
#include <optional>
#include <vector>

#include "lab/reference/tracer/ray.hpp"
#include "lab/reference/tracer/shape_meeting.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics::tracer {

struct ExactSphere {
  glm::dvec3 centre{0.0};
  double radius = 0.0;  // metres

  std::optional<ShapeMeeting> nearest(const Ray& ray, double from, double to) const;
  Bounds bounds() const;
  void append_numbers(std::vector<double>& numbers) const;
};

// The sphere of a mesh, all of whose vertices lie on it to a thousandth of its radius and all around it.
// Throws Error (BadInput) naming the mesh where they do not.
ExactSphere sphere_of(const Mesh& mesh);

}  // namespace caustics::tracer
