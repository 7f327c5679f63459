// What shaders get of the environment (passes/shared/sky_radiance.glsl).
#pragma once
#include "pipeline/scene/scene.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics {

namespace std140 {
#include "passes/shared/sky_model.glsl"
}  // namespace std140

inline std140::SoftBox shader_box(const SoftBox& box) {
  return {.middle = glm::vec3(box.middle),
          .radiance = box.radiance,
          .across = glm::vec3(box.across),
          .half_width = static_cast<float>(box.half_width),
          .upward = glm::vec3(box.upward),
          .half_height = static_cast<float>(box.half_height)};
}

inline std140::Sky shader_sky(const Environment& environment) {
  return {.zenith = environment.zenith,
          .horizon = environment.horizon,
          .ground = environment.ground,
          .has_image = environment.image ? 1 : 0,
          .backdrop = environment.backdrop.value_or(environment.ground),
          .has_boxes = environment.boxes_mean > 0.0f ? 1 : 0,
          .key = shader_box(environment.boxes[0]),
          .rim = shader_box(environment.boxes[1]),
          .fill = shader_box(environment.boxes[2]),
          .turn = glm::vec2(environment.turn)};
}

}  // namespace caustics
