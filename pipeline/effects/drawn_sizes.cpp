#include "pipeline/effects/drawn_sizes.hpp"

#include <algorithm>
#include <map>

#include "pipeline/effects/further_surfaces.hpp"
#include "pipeline/effects/surface_role.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

// The samples of each source with a size that throw a caustic, by Scene::lights.
std::map<int, std::vector<int>> samples_of_sources(const Scene& scene, const Effects& effects) {
  std::map<int, std::vector<int>> samples;
  for (const Expectation& e : effects.expectations) {
    const int source = scene.lights[static_cast<std::size_t>(e.light)].source;
    if (!e.expected || source < 0) continue;
    const Light& light = scene.sources[static_cast<std::size_t>(source)];
    if (light.shape != LightShape::Disk && !light.is_ball() && !light.is_rectangle()) continue;
    std::vector<int>& of_source = samples[source];
    if (std::find(of_source.begin(), of_source.end(), e.light) == of_source.end())
      of_source.push_back(e.light);
  }
  return samples;
}

// The sample that is nearest to its source's middle: it sees the casters as the whole light does.
int middle_sample(const Scene& scene, int source, const std::vector<int>& samples) {
  const glm::dvec3 middle = scene.sources[static_cast<std::size_t>(source)].position;
  const auto away = [&](int sample) {
    return exact::length(scene.lights[static_cast<std::size_t>(sample)].position - middle);
  };
  return *std::min_element(samples.begin(), samples.end(), [&](int a, int b) { return away(a) < away(b); });
}

}  // namespace

Effects with_drawn_sizes(Effects effects, const Scene& scene, const Settings& settings) {
  if (!settings.drawn || settings.further_share >= 1.0f) return effects;
  if (!why_not_followed(scene, settings, effects).empty()) return effects;
  for (const auto& [number, samples] : samples_of_sources(scene, effects)) {
    if (samples.size() < 2) continue;
    const int drawn = middle_sample(scene, number, samples);
    LightEffects& of_drawn = effects.lights[static_cast<std::size_t>(drawn)];
    of_drawn.size_is_drawn = true;
    glm::vec3 all(0.0f);
    for (const int sample : samples) {
      const auto index = static_cast<std::size_t>(sample);
      all += caustic_intensity(scene.lights[index], effects.lights[index]);
      effects.lights[index].casters_shadow = sample != drawn;
    }
    const Light& light = scene.lights[static_cast<std::size_t>(drawn)];
    of_drawn.of_others = all - light.color * light.intensity;
    for (Expectation& e : effects.expectations) {
      if (!e.expected || e.light == drawn || scene.lights[static_cast<std::size_t>(e.light)].source != number)
        continue;
      e = {e.light, e.mesh, false,
           "the caustic of " + quoted_name("light", light.name, static_cast<std::size_t>(drawn)) +
               " is that of its whole light"};
    }
  }
  if (any_size_is_drawn(effects) && !effects.occluders.active)
    effects.occluders = {true, "casters shadow the samples of lights that throw no caustic of their own"};
  return effects;
}

bool any_size_is_drawn(const Effects& effects) {
  return std::any_of(effects.lights.begin(), effects.lights.end(),
                     [](const LightEffects& light) { return light.size_is_drawn; });
}

bool all_sizes_are_drawn(const Effects& effects) {
  return any_size_is_drawn(effects) &&
         std::all_of(effects.expectations.begin(), effects.expectations.end(), [&](const Expectation& e) {
           return !e.expected || effects.lights[static_cast<std::size_t>(e.light)].size_is_drawn;
         });
}

}  // namespace caustics
