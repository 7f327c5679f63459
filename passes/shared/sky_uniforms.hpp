// What shaders get of the environment (passes/shared/sky_radiance.glsl).
#pragma once
#include "pipeline/scene/scene.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics {

namespace std140 {
#include "passes/shared/sky_model.glsl"
}  // namespace std140

inline std140::Sky shader_sky(const Environment& environment) {
  return {.zenith = environment.zenith,
          .horizon = environment.horizon,
          .ground = environment.ground,
          .has_image = environment.image ? 1 : 0,
          .turn = glm::vec2(environment.turn)};
}

}  // namespace caustics
