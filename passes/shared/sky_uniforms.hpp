// What shaders get of the environment (passes/shared/sky.glsl).
#pragma once
#include <glm/glm.hpp>

#include "pipeline/scene/scene.hpp"

namespace caustics {

struct SkyUniforms {
  glm::vec4 zenith{0.0f}, horizon{0.0f}, ground{0.0f};
};

inline SkyUniforms sky_uniforms(const Environment& environment) {
  return {glm::vec4(environment.zenith, 0.0f),
          glm::vec4(environment.horizon, environment.image ? 1.0f : 0.0f),
          glm::vec4(environment.ground, 0.0f)};
}

}  // namespace caustics
