// A height field of sine waves in place of its mesh.
#pragma once
#include <optional>
#include <vector>

#include "lab/reference/tracer/ray.hpp"
#include "lab/reference/tracer/shape_meeting.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics::tracer {

struct ExactWaves {
  HeightField field;
  glm::dmat3 to_field{1.0};           // inverse of field.axes
  glm::dvec2 lower{0.0}, upper{0.0};  // the rectangle that it covers: x and z in the field's coordinates
  double side = 1.0;                  // 1: the outer side is up in the field's coordinates, -1: down

  double height(const glm::dvec2& p) const;
  // The nearest meeting, whatever the waves: no step is longer than the ray's way down to the parabola that
  // bends as sharply as all waves together can.
  std::optional<ShapeMeeting> nearest(const Ray& ray, double from, double to) const;
  Bounds bounds() const;
  void append_numbers(std::vector<double>& numbers) const;
  double reach() const;  // sum of the amplitudes: no point lies farther from the level
};

// The waves of a mesh that covers a rectangle of the field's x and z and whose vertices lie on them to a
// thousandth of `reach`. Throws Error (BadInput) naming the mesh where it does not.
ExactWaves waves_of(const Mesh& mesh, const HeightField& field);

}  // namespace caustics::tracer
