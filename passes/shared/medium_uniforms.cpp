#include "passes/shared/medium_uniforms.hpp"

#include <glm/glm.hpp>

namespace caustics {

std140::Medium shader_medium(const Scene& scene) {
  const Bounds box = medium_bounds(scene);
  if (!scene.medium.present() || box.empty()) return {};
  const glm::vec3 extinction = scene.medium.extinction();
  return {.lower = glm::vec3(box.lower),
          .anisotropy = scene.medium.anisotropy,
          .upper = glm::vec3(box.upper),
          .is_grey = extinction.x == extinction.y && extinction.y == extinction.z ? 1 : 0,
          .extinction = extinction,
          .scattering = scene.medium.scattering};
}

}  // namespace caustics
