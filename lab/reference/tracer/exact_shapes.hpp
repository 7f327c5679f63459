// Shapes that meshes stand for, traced in their place in double precision: no facets.
#pragma once
#include <optional>
#include <variant>
#include <vector>

#include "lab/reference/tracer/exact_cylinder.hpp"
#include "lab/reference/tracer/exact_sphere.hpp"
#include "lab/reference/tracer/exact_waves.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics::tracer {

struct ExactShape {
  int mesh = -1;  // of Scene::meshes, that it takes the place of
  std::variant<ExactSphere, ExactCylinder, ExactWaves> form;

  // The nearest with from <= distance <= to, in lengths of the ray's direction.
  std::optional<ShapeMeeting> nearest(const Ray& ray, double from, double to) const;
  Bounds bounds() const;
  // All that it is made of, in a fixed order.
  std::vector<double> numbers() const;
};

// What the mesh stands for. Throws Error (BadInput) naming the mesh where its vertices do not lie on such a
// shape, and of waves where the scene does not state their formula.
ExactShape exact_shape_of(const Scene& scene, int mesh, ShapeKind kind);

}  // namespace caustics::tracer
