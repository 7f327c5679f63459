// What shaders get of the camera's rays (passes/shared/camera_ray.glsl).
#pragma once
#include <glm/glm.hpp>

#include "pipeline/scene/view.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics {

namespace std140 {
#include "passes/shared/camera_rays.glsl"
}  // namespace std140

inline std140::CameraRays shader_camera_rays(const View& view, int width, int height) {
  const glm::dvec2 size = view.window_upper - view.window_lower;
  return {.origin = glm::vec3(view.origin),
          .is_perspective = view.perspective ? 1 : 0,
          .right = glm::vec3(view.right),
          .up = glm::vec3(view.up),
          .forward = glm::vec3(view.forward),
          .pixel = {static_cast<float>(size.x / width), static_cast<float>(size.y / height)},
          .corner = {static_cast<float>(view.window_lower.x), static_cast<float>(view.window_lower.y)}};
}

}  // namespace caustics
