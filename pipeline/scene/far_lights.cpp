#include "pipeline/scene/far_lights.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

double cosine_of(double angle) {
  double sine, cosine;
  exact::sin_cos(angle, sine, cosine);
  return cosine;
}

}  // namespace

// KHR_lights_punctual: 1 inside the inner cone, 0 outside the outer one, the square of a ramp of cosines
// between.
double cone_falloff(const Light& light, const glm::dvec3& direction) {
  if (light.lambertian) return std::max(exact::dot(direction, light.direction), 0.0);
  if (light.type != LightType::Spot) return 1.0;
  const double outer = cosine_of(static_cast<double>(light.outer_cone));
  const double inner = std::max(cosine_of(static_cast<double>(light.inner_cone)), outer + 1e-6);
  const double ramp =
      std::clamp((exact::dot(direction, light.direction) - outer) / (inner - outer), 0.0, 1.0);
  return ramp * ramp;
}

void make_far_lights_parallel(Scene& scene) {
  const Bounds bounds = bounds_of(scene);
  if (bounds.empty()) return;
  for (Light& light : scene.lights) {
    if (light.type == LightType::Directional || light.shape != LightShape::None) continue;
    const glm::dvec3 way = bounds.centre() - light.position;
    const double distance = exact::length(way);
    if (!(distance > kFarLight * bounds.radius()) || distance > static_cast<double>(light.range)) continue;
    const glm::dvec3 direction = way / distance;
    const double lux =
        static_cast<double>(light.intensity) * cone_falloff(light, direction) / (distance * distance);
    light.intensity = static_cast<float>(std::min(lux, 1e30));
    light.type = LightType::Directional;
    light.direction = direction;
    light.lambertian = false;
    const std::string note = "light '" + light.name + "' is over " +
                             std::to_string(static_cast<int>(kFarLight)) +
                             " times as far away as the scene is large: drawn as parallel light.";
    // A scene that moves comes here for every frame.
    if (std::find(scene.notes.begin(), scene.notes.end(), note) == scene.notes.end())
      scene.notes.push_back(note);
  }
}

}  // namespace caustics
