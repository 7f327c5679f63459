#include "pipeline/renderer/landed_light.hpp"

#include <algorithm>

#include "pipeline/effects/effects.hpp"
#include "pipeline/renderer/pilot_rays.hpp"
#include "pipeline/renderer/widest_views.hpp"
#include "pipeline/scene/defaults.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

double brightest_channel(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

}  // namespace

LandedLight::LandedLight(const Scene& scene, const Settings& settings, const Pilot& pilot)
    : scene_(scene), settings_(settings), pilot_(pilot) {}

std::vector<Landed> LandedLight::find(int step) {
  Effects effects = effects_of(scene_, settings_);
  effects.further_surfaces = {};  // as if it were followed: whatever the passes do, light lands on its own
  std::vector<Landed> landed;
  if (!effects.caustics.active) return landed;
  if (!paths_) {
    tables_.emplace(scene_, effects, pilot_.device);
    paths_.emplace(*tables_, effects, settings_, pilot_.registry);
  }
  Settings even = settings_;  // whatever the frame's grid is: the same rays, the same sun and camera
  even.grid = kPilotRaysASide;
  const glm::dvec3 middle = subject_of(scene_).centre();
  std::vector<LightLanding> landings;
  const std::vector<int> lights = lights_to_pilot(scene_, effects);
  step = std::min(step * pilot_step(lights.size()), kPilotRaysASide / 4);
  for (const int number : lights) {
    const Light& light = scene_.lights[static_cast<std::size_t>(number)];
    const View casters = widest_views(scene_, effects, even, number).caster;
    landings.clear();
    paths_->follow(pilot_rays(light, casters, step), landings);
    double all = 0.0;
    for (const LightLanding& landing : landings) all += brightest_channel(landing.flux);
    const double away = casters.perspective ? exact::length(middle - light.position) : 1.0;
    const double side = static_cast<double>(kPilotRaysASide) / step;
    const double area = casters.window_area() * away * away / (side * side);
    const auto samples = std::count_if(scene_.lights.begin(), scene_.lights.end(), [&](const Light& other) {
      return light.source >= 0 && other.source == light.source;
    });
    const glm::dvec3 sent =
        glm::dvec3(light.color) * (static_cast<double>(light.intensity) * area / (away * away) *
                                   static_cast<double>(std::max<std::ptrdiff_t>(samples, 1)));
    for (const LightLanding& landing : landings) {
      const double flux = brightest_channel(landing.flux);
      landed.push_back({landing.position, flux / std::max(all, 1e-300), flux * area,
                        exact::luminance(landing.flux * sent), landing.mesh});
    }
  }
  return landed;
}

}  // namespace caustics
