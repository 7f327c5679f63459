// The points of a light with a size from which the pass walk sends light to its grid vertices, for rays that
// are held against it (passes/shared/wide_light.glsl and way_draw.glsl, in double precision).
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "pipeline/measure/light_paths.hpp"
#include "pipeline/scene/emitter.hpp"

namespace caustics {

class DrawnPoints {
 public:
  DrawnPoints(const Scene& scene, const Light& source);
  // The ray from the vertex' own point of the source to p, where the vertex is, scene space. `ray`: the one
  // from the light's view.
  LightRay ray(LightRay ray, const glm::dvec3& p, int column, int row) const;
  // Returns how much light the source sends along such a ray, relative to the most that it sends along any.
  double toward(const LightRay& ray, int column, int row) const;
  // Is the source near by, and no sun?
  bool has_place() const;

 private:
  static int number(int column, int row);
  glm::dvec3 start(const glm::dvec3& p, int number) const;

  const Light& source_;
  std::vector<SurfacePoint> points_;  // of a mesh that is neither ball nor rectangle
};

}  // namespace caustics
