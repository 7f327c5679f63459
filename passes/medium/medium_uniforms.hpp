// What shaders get of the medium and of the camera's rays through it.
#pragma once
#include <glm/glm.hpp>

#include "pipeline/plan/pass.hpp"

namespace caustics {

struct MediumUniforms {
  using vec4 = glm::vec4;
#include "passes/medium/medium_uniforms.glsl"
};

// Zeros without a medium.
MediumUniforms medium_uniforms(const Scene& scene);

// A pass's uniforms with those of the medium behind them, for the variant of its shader with HAZE.
UniformBytes with_medium(UniformBytes bytes, const Scene& scene);

struct ViewRayUniforms {
  using vec4 = glm::vec4;
  using mat4 = glm::mat4;
#include "passes/medium/view_ray_uniforms.glsl"
};

ViewRayUniforms view_ray_uniforms(const View& view, int width, int height);

}  // namespace caustics
