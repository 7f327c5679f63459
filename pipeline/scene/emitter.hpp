// Meshes that shine: as lights, and points spread over their area.
#pragma once
#include <vector>

#include "pipeline/scene/scene.hpp"

namespace caustics {

struct SurfacePoint {
  glm::dvec3 position{0.0}, normal{0.0};  // the unit normal of the side that shines
};

// A mesh of LightShape::Mesh. Both sides shine where it is an open sheet of a double-sided
// material.
class Emitter {
 public:
  Emitter(const Scene& scene, const Light& light);
  // Square metres.
  double area() const { return sums_.empty() ? 0.0 : sums_.back(); }
  // Points that stand for equal areas, near in place and normal; one point stands near the middle.
  std::vector<SurfacePoint> spread(int count) const;

 private:
  // `along` (0..1) chooses the triangle by its share of the area, u and v (0..1) the point on it.
  SurfacePoint point(double along, double u, double v) const;

  const Mesh& mesh_;
  std::vector<double> sums_;  // area of the triangles up to and with each; then of their back sides
};

// Makes a light of LightShape::Mesh of every mesh whose material shines (Material::emissive), after
// the lights that the scene has. To be called before sample_lights.
void add_emissive_lights(Scene& scene);

}  // namespace caustics
