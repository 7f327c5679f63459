// The exact shape that a file says a mesh stands for: `extras.exact_shape` (docs/reference.md). Rendering
// takes the mesh as it is; `caustics reference --exact` traces the shape in its place.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace caustics {

enum class ShapeKind : std::uint8_t { Sphere, Cylinder, Waves };

// One of the waves that a height field is the sum of: amplitude * sin(k.x x + k.y z + phase).
struct SineWave {
  double amplitude = 0.0;  // in the mesh's own unit of length
  glm::dvec2 k{0.0};       // radians per unit of length, along x and z
  double phase = 0.0;      // radians
};

// y = level + the sum of the waves, in the mesh's own coordinates.
struct HeightField {
  double level = 0.0;
  std::vector<SineWave> waves{};
  // Where these coordinates lie in scene space, metres: p -> axes * p + origin.
  glm::dmat3 axes{1.0};
  glm::dvec3 origin{0.0};
};

struct StatedShape {
  int mesh = -1;  // of Scene::meshes
  ShapeKind kind = ShapeKind::Sphere;
  HeightField field{};  // of Waves; spheres and cylinders are recognised from their vertices
};

}  // namespace caustics
