// Rays of a light towards the casters.
#pragma once
#include <vector>

#include "lab/reference/tracer/numbers.hpp"
#include "lab/reference/tracer/world.hpp"

namespace caustics::tracer {

struct LightRay {
  Ray ray;  // unit direction
  // Relative to the light's intensity: square metres (lumen per lux) of a directional light, steradians
  // (lumen per candela) of the others; times a cone's or a Lambertian emitter's falloff.
  double flux = 0.0;
};

// A point of a light, drawn evenly over its shape as sample_lights spreads its own (docs/lights.md).
struct LightPoint {
  glm::dvec3 position{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};  // the way it shines, unit
};

// A light's falloff towards a unit direction (passes/shared/cone_falloff.glsl).
class Falloff {
 public:
  explicit Falloff(const Light& light);
  double at(const glm::dvec3& direction, const glm::dvec3& axis) const;

 private:
  enum class Kind { Even, Lambert, Cone } kind_ = Kind::Even;
  double scale_ = 0.0, offset_ = 0.0;
};

class LightShapePoints {
 public:
  LightShapePoints(const Scene& scene, const Light& light);
  // u, v, w in [0, 1).
  LightPoint point(double u, double v, double w) const;
  bool has_size() const { return light_.shape != LightShape::None; }

 private:
  LightPoint on_mesh(double u, double v, double w) const;

  const Scene& scene_;
  Light light_;
  std::vector<double> areas_;  // summed up, of a mesh's triangles and then of their backs
};

class Emission {
 public:
  // `source`: index into Scene::sources.
  Emission(const World& world, int source);
  // Ray `index` of side * side: its direction in a cell of its own, jittered; the place on the light in a
  // cell of its own too, shuffled by `batch`. The flux of all together is what shines on the casters' window.
  LightRay ray(int index, int side, int batch, Numbers& numbers) const;

 private:
  // Across the light: metres, or tangents around `frame`'s axis.
  struct Window {
    View view;
    glm::dvec2 lower{0.0}, upper{0.0};
    bool all_around = false;  // the light stands too near to the casters for a window
  };
  Window window_of(const LightPoint& point, const std::vector<glm::dvec3>& around) const;
  LightRay parallel(const Window& window, double u, double v) const;
  LightRay from_point(const Window& window, const LightPoint& point, double u, double v) const;

  const World& world_;
  const Light& light_;
  LightShapePoints shape_;
  Falloff falloff_;
  std::vector<glm::dvec3> corners_;  // of the casters' box
  glm::dvec3 centre_{0.0};
  Window fixed_;  // of a light without a size, tight around the vertices
};

}  // namespace caustics::tracer
