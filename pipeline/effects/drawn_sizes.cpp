#include "pipeline/effects/drawn_sizes.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "pipeline/effects/further_surfaces.hpp"
#include "pipeline/effects/surface_role.hpp"
#include "pipeline/scene/emitter.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

constexpr double kWideSample = 0.01;  // a sample's radius over its distance

// A source with a size, or one side of a sheet that shines to both.
struct LightSide {
  int source = 0;
  bool back = false;
  auto operator<=>(const LightSide&) const = default;
};

LightSide side_of(const Scene& scene, int sample) {
  const Light& light = scene.lights[static_cast<std::size_t>(sample)];
  if (light.source < 0) return {light.source};
  const Light& source = scene.sources[static_cast<std::size_t>(light.source)];
  const bool sheet = source.shape == LightShape::Mesh && source.is_rectangle();
  return {light.source, sheet && exact::dot(light.direction, source.direction) < 0.0};
}

// The samples of each that throw a caustic, by Scene::lights.
std::map<LightSide, std::vector<int>> samples_of_sides(const Scene& scene, const Effects& effects) {
  std::map<LightSide, std::vector<int>> samples;
  const std::vector<int> lamps = lamps_of_points(scene);
  for (const Expectation& e : effects.expectations) {
    const LightSide side = side_of(scene, e.light);
    if (!e.expected || side.source < 0) continue;
    const Light& light = scene.sources[static_cast<std::size_t>(side.source)];
    const bool lamp = std::find(lamps.begin(), lamps.end(), side.source) != lamps.end();
    if (light.shape != LightShape::Disk && !light.is_ball() && !light.is_rectangle() && !lamp) continue;
    std::vector<int>& of_side = samples[side];
    if (std::find(of_side.begin(), of_side.end(), e.light) == of_side.end()) of_side.push_back(e.light);
  }
  return samples;
}

// The cosine by which a sample of a lamp faces the middle of these casters; nothing if one of them does not
// lie wholly before it.
std::optional<double> facing(const Scene& scene, const std::set<int>& casters, const Light& sample) {
  Bounds all;
  for (const int caster : casters) {
    const Bounds box = bounds_of(scene.meshes[static_cast<std::size_t>(caster)]);
    const glm::dvec3 half = 0.5 * (box.upper - box.lower);
    const double nearest = exact::dot(box.centre() - sample.position, sample.direction) -
                           exact::dot(half, glm::abs(sample.direction));
    if (!(nearest > 0.0)) return {};
    all.add(box);
  }
  return exact::dot(sample.direction, exact::normalise(all.centre() - sample.position, sample.direction));
}

// The sample that sees the casters as the whole light does: the one nearest to its source's middle; of a lamp
// the one that faces them most, of those that see all of them. -1: there is none.
int middle_sample(const Scene& scene, const Effects& effects, int source, const std::vector<int>& samples) {
  const Light& whole = scene.sources[static_cast<std::size_t>(source)];
  std::set<int> all;
  if (whole.is_lamp())
    for (const int sample : samples) all.merge(casters_of(effects, sample));
  int middle = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const int sample : samples) {
    const Light& light = scene.lights[static_cast<std::size_t>(sample)];
    double away = exact::length(light.position - whole.position);
    if (whole.is_lamp()) {
      const std::optional<double> cosine = facing(scene, all, light);
      if (!cosine) continue;
      away = -*cosine;
    }
    if (away >= least) continue;
    least = away;
    middle = sample;
  }
  return middle;
}

// Does the sample's share of its light look wide from the casters? Between its shadows' edges and its
// neighbours' lies more than a texel then.
bool is_wide(const Scene& scene, const Effects& effects, int sample) {
  const Light& light = scene.lights[static_cast<std::size_t>(sample)];
  Bounds all;
  for (const int caster : casters_of(effects, sample))
    all.add(bounds_of(scene.meshes[static_cast<std::size_t>(caster)]));
  return light.sample_radius > kWideSample * exact::length(all.centre() - light.position);
}

// The intensity of all samples together, lux or candela. A lamp's samples that look away from the casters
// throw no caustic, but they count, because its points are all over it.
glm::vec3 intensity_of_all(const Scene& scene, const Effects& effects, int drawn,
                           const std::vector<int>& samples) {
  const auto of = [&](int sample) {
    const auto index = static_cast<std::size_t>(sample);
    return caustic_intensity(scene.lights[index], effects.lights[index]);
  };
  const int source = scene.lights[static_cast<std::size_t>(drawn)].source;
  if (scene.sources[static_cast<std::size_t>(source)].is_lamp())
    return of(drawn) * static_cast<float>(std::count_if(scene.lights.begin(), scene.lights.end(),
                                                        [&](const Light& l) { return l.source == source; }));
  glm::vec3 all(0.0f);
  for (const int sample : samples) all += of(sample);
  return all;
}

}  // namespace

std::set<int> casters_of(const Effects& effects, int light) {
  std::set<int> casters;
  for (const Expectation& e : effects.expectations)
    if (e.expected && e.light == light) casters.insert(e.mesh);
  return casters;
}

Effects with_drawn_sizes(Effects effects, const Scene& scene, const Settings& settings) {
  if (!settings.drawn || settings.further_share >= 1.0f) return effects;
  if (!why_not_followed(settings, effects).empty()) return effects;
  for (const auto& [side, samples] : samples_of_sides(scene, effects)) {
    if (samples.size() < 2) continue;
    const int drawn = middle_sample(scene, effects, side.source, samples);
    if (drawn < 0) continue;
    LightEffects& of_drawn = effects.lights[static_cast<std::size_t>(drawn)];
    of_drawn.size_is_drawn = true;
    const Light& light = scene.lights[static_cast<std::size_t>(drawn)];
    const glm::vec3 all = intensity_of_all(scene, effects, drawn, samples);
    of_drawn.of_others = all - light.color * light.intensity;
    for (const int sample : samples) {
      LightEffects& own = effects.lights[static_cast<std::size_t>(sample)];
      own.casters_shadow = sample != drawn;
      own.shadow_divide = own.casters_shadow && is_wide(scene, effects, sample) ? 2 : 1;
    }
    for (Expectation& e : effects.expectations) {
      if (!e.expected || e.light == drawn || side_of(scene, e.light) != side) continue;
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
