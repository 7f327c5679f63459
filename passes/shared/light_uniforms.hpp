// What shaders get of a light besides its frames (passes/shared/light_intensity.glsl).
#pragma once
#include <glm/glm.hpp>

#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics {

// A spot light's cone: falloff = clamp(cos(angle) * scale + offset, 0, 1)^2 (KHR_lights_punctual,
// inner and outer cone angles); scale 0 for lights without a cone. Not squared where z is 1: scale 1
// and offset 0 are a Lambertian emitter's cosine.
struct LightCone {
  glm::vec4 axis{0.0f};
  glm::vec4 scale_offset{0.0f};
};

inline LightCone light_cone(const Light& light) {
  LightCone cone;
  cone.axis = glm::vec4(glm::vec3(light.direction), 0.0f);
  if (light.lambertian) cone.scale_offset = {1.0f, 0.0f, 1.0f, 0.0f};
  if (light.type != LightType::Spot) return cone;
  double sine, cos_outer, cos_inner;
  exact::sin_cos(static_cast<double>(light.outer_cone), sine, cos_outer);
  exact::sin_cos(static_cast<double>(light.inner_cone), sine, cos_inner);
  const double scale = 1.0 / (cos_inner - cos_outer > 0.001 ? cos_inner - cos_outer : 0.001);
  cone.scale_offset =
      glm::vec4(static_cast<float>(scale), static_cast<float>(-cos_outer * scale), 0.0f, 0.0f);
  return cone;
}

}  // namespace caustics
