#include "lab/reference/tracer/exact_shapes.hpp"

#include <algorithm>

#include "pipeline/gpu/error.hpp"

namespace caustics::tracer {

std::optional<ShapeMeeting> ExactShape::nearest(const Ray& ray, double from, double to) const {
  return std::visit([&](const auto& shape) { return shape.nearest(ray, from, to); }, form);
}

Bounds ExactShape::bounds() const {
  return std::visit([](const auto& shape) { return shape.bounds(); }, form);
}

std::vector<double> ExactShape::numbers() const {
  std::vector<double> numbers{static_cast<double>(mesh), static_cast<double>(form.index())};
  std::visit([&](const auto& shape) { shape.append_numbers(numbers); }, form);
  return numbers;
}

ExactShape exact_shape_of(const Scene& scene, int mesh, ShapeKind kind) {
  const Mesh& m = scene.meshes[static_cast<std::size_t>(mesh)];
  if (kind == ShapeKind::Sphere) return {mesh, sphere_of(m)};
  if (kind == ShapeKind::Cylinder) return {mesh, cylinder_of(m)};
  const auto stated = std::find_if(
      scene.stated_shapes.begin(), scene.stated_shapes.end(),
      [&](const StatedShape& shape) { return shape.mesh == mesh && shape.kind == ShapeKind::Waves; });
  if (stated == scene.stated_shapes.end())
    throw Error(ExitCode::BadInput, "mesh '" + m.name +
                                        "' is not known to be waves: the file has to state their formula in "
                                        "extras.exact_shape (docs/reference.md)");
  return {mesh, waves_of(m, stated->field)};
}

}  // namespace caustics::tracer
