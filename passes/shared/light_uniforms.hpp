// What shaders get of a light besides its views (passes/shared/light.glsl, light_cone.glsl).
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "pipeline/plan/pass.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/scene.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics {

// Of an angle in radians, with all its digits near 0.
inline double one_less_cosine(double angle) {
  double sine, cosine;
  exact::sin_cos(0.5 * angle, sine, cosine);
  return 2.0 * sine * sine;
}

namespace std140 {
#include "passes/shared/light_cone.glsl"

#include "passes/shared/light.glsl"
}  // namespace std140

// A spot light's cone: falloff = clamp(offset - (1 - cos(angle)) scale, 0, 1)^2 (KHR_lights_punctual, inner
// and outer cone angles). Equal cones have an edge a thousandth as wide as the cone, however narrow that is.
inline std140::LightCone shader_cone(const Light& light) {
  const int lambertian = light.lambertian ? 1 : 0;
  std140::LightCone cone{
      .axis = glm::vec3(light.direction), .scale = 0.0f, .offset = 0.0f, .lambertian = lambertian};
  if (light.type != LightType::Spot) return cone;
  const double outer = one_less_cosine(static_cast<double>(light.outer_cone));
  const double inner = one_less_cosine(static_cast<double>(light.inner_cone));
  const double scale = 1.0 / std::max({outer - inner, 1e-3 * outer, 1e-30});
  cone.scale = static_cast<float>(scale);
  cone.offset = static_cast<float>(outer * scale);
  cone.lambertian = 0;
  return cone;
}

inline glm::vec3 caustic_intensity(const PassContext& context) {
  return caustic_intensity(*context.light, context.of_light ? *context.of_light : LightEffects{});
}

// `direction`: the way a directional light shines, as its views have it.
inline std140::Light shader_light(const Light& light, const glm::dvec3& direction) {
  const bool directional = light.type == LightType::Directional;
  return {.position = glm::vec3(light.position),
          .has_position = directional ? 0 : 1,
          .direction = glm::vec3(direction),
          .range = !directional && std::isfinite(light.range) ? light.range : 0.0f,
          .intensity = light.color * light.intensity,
          .radius = directional ? 0.0f : static_cast<float>(light.sample_radius),
          .cone = shader_cone(light)};
}

}  // namespace caustics
