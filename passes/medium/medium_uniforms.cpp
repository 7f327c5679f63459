#include "passes/medium/medium_uniforms.hpp"

namespace caustics {

MediumUniforms medium_uniforms(const Scene& scene) {
  const Bounds box = medium_bounds(scene);
  if (!scene.medium.present() || box.empty()) return {};
  const glm::vec3 extinction = scene.medium.extinction(), scattering = scene.medium.scattering;
  const bool grey = extinction.x == extinction.y && extinction.y == extinction.z;
  return {.medium_lower = glm::vec4(glm::vec3(box.lower), scene.medium.anisotropy),
          .medium_upper = glm::vec4(glm::vec3(box.upper), grey ? 1.0f : 0.0f),
          .extinction = glm::vec4(extinction, 0.0f),
          .scattering = glm::vec4(scattering, 0.0f)};
}

UniformBytes with_medium(UniformBytes bytes, const Scene& scene) {
  const UniformBytes more = uniform_bytes(medium_uniforms(scene));
  bytes.insert(bytes.end(), more.begin(), more.end());
  return bytes;
}

ViewRayUniforms view_ray_uniforms(const View& view, int width, int height) {
  const ViewUniforms packed = pack(view);
  const glm::dvec2 size = view.window_upper - view.window_lower;
  return {.from_scene = packed.from_scene,
          .window = packed.window,
          .depth = packed.depth,
          .eye = glm::vec4(glm::vec3(view.origin), view.perspective ? 1.0f : 0.0f),
          .right = glm::vec4(glm::vec3(view.right), 0.0f),
          .up = glm::vec4(glm::vec3(view.up), 0.0f),
          .forward = glm::vec4(glm::vec3(view.forward), 0.0f),
          .pixel = {static_cast<float>(size.x / width), static_cast<float>(size.y / height),
                    static_cast<float>(view.window_lower.x), static_cast<float>(view.window_lower.y)}};
}

}  // namespace caustics
