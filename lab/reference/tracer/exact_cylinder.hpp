// A circular cylinder in place of its mesh: one wall, or two of one axis as of a tube, with or without flat
// lids.
#pragma once
#include <optional>
#include <vector>

#include "lab/reference/tracer/ray.hpp"
#include "lab/reference/tracer/shape_meeting.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics::tracer {

struct ExactCylinder {
  struct Wall {
    double radius = 0.0;   // metres
    double outward = 1.0;  // 1: its outer side looks away from the axis, -1: towards it
  };
  glm::dvec3 foot{0.0};                       // on the axis, at the lower rim
  glm::dvec3 axis{0.0, 1.0, 0.0};             // unit
  double height = 0.0;                        // metres, from rim to rim
  std::vector<Wall> walls;                    // one or two, the wider one first
  bool lower_lid = false, upper_lid = false;  // flat, from the inner wall, or the axis, to the outer one
  // A single wall may reach around a part of the circle only: to both sides of `middle` (unit, across the
  // axis) as far as the cosine of the angle to it is no less than this. -2: all around.
  glm::dvec3 middle{1.0, 0.0, 0.0};
  double least_cosine = -2.0;

  std::optional<ShapeMeeting> nearest(const Ray& ray, double from, double to) const;
  Bounds bounds() const;
  void append_numbers(std::vector<double>& numbers) const;
};

// The cylinder of a mesh: triangles along one axis form its walls, smooth ones by their normals, and
// triangles across it its lids; vertices lie on it to a thousandth of the outer radius, and no wall has a
// hole. Throws Error (BadInput) naming the mesh where it is none.
ExactCylinder cylinder_of(const Mesh& mesh);

}  // namespace caustics::tracer
