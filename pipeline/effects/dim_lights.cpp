#include "pipeline/effects/dim_lights.hpp"

#include <algorithm>

#include "pipeline/effects/surface_role.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics {

namespace {

constexpr int kMostDivided = 8;
// No side becomes smaller than these; a cube's six faces need the larger one.
constexpr int kLeastMap = 32, kLeastCube = 64, kLeastShadow = 256;

// A light of full / n^2 has sides of 1 / n: all lights' grids together are about as many vertices as those of
// 1 / full lights in full.
int divided_by(double share, double full) {
  int divide = 1;
  while (divide < kMostDivided && share * (divide + 1) * (divide + 1) <= full) ++divide;
  return divide;
}

std::string percent(float share) { return rounded_text(100.0 * static_cast<double>(share), 3) + " %"; }

std::string source_name(const Scene& scene, int source) {
  const auto index = static_cast<std::size_t>(source);
  return quoted_name("light", (scene.sources.empty() ? scene.lights : scene.sources)[index].name, index);
}

std::string counted(std::size_t lights) { return grouped(lights) + (lights == 1 ? " light" : " lights"); }

}  // namespace

Effects with_dim_lights(Effects effects, const Scene& scene, const Settings& settings,
                        const std::vector<LightShare>& shares) {
  if (shares.empty()) return effects;
  const auto share_of = [&](int light) -> const LightShare& {
    const int source = scene.lights[static_cast<std::size_t>(light)].source;
    return shares[static_cast<std::size_t>(source < 0 ? light : source)];
  };
  const std::string together = "less than " + percent(settings.least_light) + " of the light on any caster";
  for (Expectation& e : effects.expectations) {
    if (!e.expected) continue;
    const LightShare& found = share_of(e.light);
    if (!found.left_out && found.drawn_with < 0) continue;
    effects.lights[static_cast<std::size_t>(e.light)].casters_shadow = true;
    e = {e.light, e.mesh, false,
         found.left_out
             ? "it is one of the weakest lights, which together are " + together
             : "the caustic of " + source_name(scene, found.drawn_with) + ", near it, stands for its own"};
  }
  std::size_t smaller = 0, without = 0, stood_for = 0;
  int most = 1;
  std::vector<bool> seen(shares.size());
  for (std::size_t l = 0; l < effects.lights.size(); ++l) {
    const LightShare& found = share_of(static_cast<int>(l));
    int& divide = effects.lights[l].divide;
    effects.lights[l].of_others = found.of_others;
    // Impostors are one map for all lights.
    divide = effects.distance_impostors.active || found.left_out || found.drawn_with >= 0
                 ? 1
                 : divided_by(found.share, static_cast<double>(settings.full_light));
    most = std::max(most, divide);
    const auto source = static_cast<std::size_t>(&found - shares.data());
    if (seen[source]) continue;
    seen[source] = true;
    smaller += divide > 1 ? 1 : 0;
    without += found.left_out ? 1 : 0;
    stood_for += found.drawn_with >= 0 ? 1 : 0;
  }
  std::string reason;
  if (smaller > 0)
    reason = counted(smaller) + " of " + grouped(shares.size()) + " with less than " +
             percent(settings.full_light) +
             " of the light on any caster each: the sides of their grids and maps are divided by up to " +
             std::to_string(most) + " (-D light.full=0 would not)";
  if (without > 0)
    reason += (reason.empty() ? "" : "; ") + counted(without) + ", together " + together +
              ", without a caustic (-D light.least=0 gives " + (without == 1 ? "it one)" : "them theirs)");
  if (stood_for > 0)
    reason +=
        (reason.empty() ? "" : "; ") + counted(stood_for) +
        " drawn by the caustics of others near them, brighter by theirs (-D light.most=0 gives each its own)";
  if ((without > 0 || stood_for > 0) && !effects.occluders.active)
    effects.occluders = {true, "casters shadow the lights that throw no caustic of their own"};
  effects.dim_lights = {!reason.empty(), reason.empty() ? "no light is much weaker than the others" : reason};
  return effects;
}

LightSettings::LightSettings(const Settings& settings, const Effects& effects)
    : whole_(settings), effects_(effects) {
  for (const LightEffects& light : effects.lights) {
    if ((light.divide <= 1 && light.shadow_divide <= 1) || smaller_.contains(key(light))) continue;
    Settings& own = smaller_.emplace(key(light), settings).first->second;
    const int least = light.all_around.empty() ? kLeastMap : kLeastCube;
    for (Side* side : {&own.grid, &own.map})
      side->count = std::max(std::min(side->count, least), side->count / light.divide);
    own.shadow =
        std::max(std::min(own.shadow, kLeastShadow), own.shadow / (light.divide * light.shadow_divide));
  }
}

LightSettings::Key LightSettings::key(const LightEffects& light) {
  return {light.divide, light.shadow_divide, !light.all_around.empty()};
}

const Settings& LightSettings::operator[](int light) const {
  if (light < 0 || smaller_.empty()) return whole_;
  const LightEffects& own = effects_.lights[static_cast<std::size_t>(light)];
  const auto found = smaller_.find(key(own));
  return found == smaller_.end() ? whole_ : found->second;
}

}  // namespace caustics
