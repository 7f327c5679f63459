#include "passes/shared/receiver_search_uniforms.hpp"

#include <algorithm>

namespace caustics {

Bounds receivers_box(const PassContext& context) {
  Bounds box;
  const std::vector<SurfaceRole>& surfaces = context.effects->surfaces;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].role == Role::Receiver) box.add(bounds_of(context.scene->meshes[i]));
  if (box.empty()) return {glm::dvec3(0.0), glm::dvec3(0.0)};
  const glm::dvec3 slack(1e-4 * std::max(box.radius(), 1e-9));
  return {box.lower - slack, box.upper + slack};
}

}  // namespace caustics
