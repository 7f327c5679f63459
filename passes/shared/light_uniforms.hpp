// What shaders get of a light besides its views (passes/shared/light.glsl, light_cone.glsl).
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/scene.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics {

// A spot light's cone: falloff = clamp(offset - (1 - cos(angle)) scale, 0, 1)^2 (KHR_lights_punctual, inner
// and outer cone angles), scale and offset in x and y; scale 0 for lights without a cone. Where z is 1 the
// falloff is a Lambertian emitter's cosine instead.
struct LightCone {
  glm::vec4 axis{0.0f};
  glm::vec4 scale_offset{0.0f};
};

// Of an angle in radians, with all its digits near 0.
inline double one_less_cosine(double angle) {
  double sine, cosine;
  exact::sin_cos(0.5 * angle, sine, cosine);
  return 2.0 * sine * sine;
}

inline LightCone light_cone(const Light& light) {
  LightCone cone;
  cone.axis = glm::vec4(glm::vec3(light.direction), 0.0f);
  if (light.lambertian) cone.scale_offset = {0.0f, 0.0f, 1.0f, 0.0f};
  if (light.type != LightType::Spot) return cone;
  const double outer = one_less_cosine(static_cast<double>(light.outer_cone));
  const double inner = one_less_cosine(static_cast<double>(light.inner_cone));
  // Equal cones have an edge a thousandth as wide as the cone, however narrow that is.
  const double scale = 1.0 / std::max({outer - inner, 1e-3 * outer, 1e-30});
  cone.scale_offset = glm::vec4(static_cast<float>(scale), static_cast<float>(outer * scale), 0.0f, 0.0f);
  return cone;
}

namespace std140 {
#include "passes/shared/light_cone.glsl"
#include "passes/shared/light.glsl"
}  // namespace std140

// The same as one struct.
inline std140::LightCone shader_cone(const Light& light) {
  const LightCone cone = light_cone(light);
  return {.axis = glm::vec3(cone.axis),
          .scale = cone.scale_offset.x,
          .offset = cone.scale_offset.y,
          .lambertian = cone.scale_offset.z != 0.0f ? 1 : 0};
}

// `direction`: the way a directional light shines, as its views have it.
inline std140::Light shader_light(const Light& light, const glm::dvec3& direction) {
  const bool directional = light.type == LightType::Directional;
  return {.position = glm::vec3(light.position),
          .has_position = directional ? 0 : 1,
          .direction = glm::vec3(direction),
          .range = !directional && std::isfinite(light.range) ? light.range : 0.0f,
          .intensity = light.color * light.intensity,
          .cone = shader_cone(light)};
}

}  // namespace caustics
