// What shaders get of the environment (passes/shared/sky_radiance.glsl).
#pragma once
#include <glm/glm.hpp>

#include "pipeline/scene/scene.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics {

struct SkyUniforms {
  glm::vec4 zenith{0.0f}, horizon{0.0f}, ground{0.0f};
};

inline SkyUniforms sky_uniforms(const Environment& environment) {
  return {glm::vec4(environment.zenith, 0.0f),
          glm::vec4(environment.horizon, environment.image ? 1.0f : 0.0f),
          glm::vec4(environment.ground, 0.0f)};
}

namespace std140 {
#include "passes/shared/sky_model.glsl"
}  // namespace std140

// The same as one struct.
inline std140::Sky shader_sky(const Environment& environment) {
  return {.zenith = environment.zenith,
          .horizon = environment.horizon,
          .ground = environment.ground,
          .has_image = environment.image ? 1 : 0};
}

}  // namespace caustics
