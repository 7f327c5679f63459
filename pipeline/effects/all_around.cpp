#include "pipeline/effects/all_around.hpp"

#include <cmath>

#include "pipeline/effects/surface_role.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/settings/check_settings.hpp"

namespace caustics {

namespace {

bool is_receiver(const Effects& effects, std::size_t mesh) {
  return effects.surfaces[mesh].role == Role::Receiver;
}

void add_impostors(const Scene& scene, const Settings& settings, Effects& effects) {
  const bool wanted = settings.estimator == Estimator::Impostor;
  const bool active = wanted && effects.caustics.active;
  effects.distance_impostors = {active, active
                                            ? "the estimator asked for looks landings up around the casters"
                                        : wanted ? "there is no caustic"
                                                 : "the estimator does not use them"};
  if (!active) return;
  Bounds casters;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (is_caster(effects.surfaces[i].role)) casters.add(bounds_of(scene.meshes[i]));
  const Distances distances =
      distances_from(casters.centre(), scene, [&](std::size_t i) { return is_receiver(effects, i); });
  effects.impostors = cube_view(casters.centre(), distances);
}

// Do the casters that this light reaches fit a window towards their middle?
bool casters_fit(const Scene& scene, const Light& light, const std::vector<std::size_t>& casters) {
  Bounds bounds;
  for (const std::size_t i : casters) bounds.add(bounds_of(scene.meshes[i]));
  const View axes =
      view_along(light.position, exact::normalise(bounds.centre() - light.position, light.direction));
  for (const std::size_t i : casters)
    for (const Vertex& v : scene.meshes[i].vertices) {
      const glm::dvec3 q = axes.coordinates(glm::dvec3(v.position));
      if (!(std::max(std::fabs(q.x), std::fabs(q.y)) <= kWidestTangent * q.z)) return false;
    }
  return true;
}

// Do receivers stand on all sides of a point?
bool enclosed(const Scene& scene, const Effects& effects, const glm::dvec3& p) {
  Bounds bounds;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (is_receiver(effects, i)) bounds.add(bounds_of(scene.meshes[i]));
  if (bounds.empty()) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (!(p[axis] > bounds.lower[axis] && p[axis] < bounds.upper[axis])) return false;
  return true;
}

// Why a light is to see all around by itself, or nothing.
std::string calls_for_cube(const Scene& scene, const Settings& settings, const Effects& effects, int index) {
  const Light& light = scene.lights[static_cast<std::size_t>(index)];
  if (light.type != LightType::Point || light.lambertian) return {};
  std::vector<std::size_t> casters;
  bool any_way = settings.reflections;
  for (const Expectation& e : effects.expectations) {
    if (e.light != index || !e.expected) continue;
    casters.push_back(static_cast<std::size_t>(e.mesh));
    any_way |= effects.surfaces[casters.back()].role == Role::Mirror;
  }
  if (casters.empty()) return {};
  if (!casters_fit(scene, light, casters)) return "its casters stand all around it";
  if (any_way && enclosed(scene, effects, light.position))
    return "what mirrors send its light to stands all around it";
  return {};
}

void add_lights(const Scene& scene, const Settings& settings, Effects& effects) {
  const std::string small = effects.scattering.active ? "a medium that scatters allows one window only"
                                                      : too_small_for_cubes(settings);
  std::string first, refused;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    std::string reason;
    if (settings.cube == Cube::Auto) reason = calls_for_cube(scene, settings, effects, static_cast<int>(i));
    if (settings.cube == Cube::On && light.type != LightType::Directional) reason = "as asked for";
    if (!small.empty() && !reason.empty()) {
      refused = small;
      reason.clear();
    }
    if (first.empty() && !reason.empty())
      first = quoted_name("light", source_of(scene, static_cast<int>(i)).name, i) + ": " + reason;
    effects.lights[i].all_around = std::move(reason);
  }
  const auto count = static_cast<std::size_t>(
      std::count_if(effects.lights.begin(), effects.lights.end(),
                    [](const LightEffects& one) { return !one.all_around.empty(); }));
  if (count > 1) first += ", and " + std::to_string(count - 1) + " more";
  effects.all_around = {count > 0, count > 0                    ? first
                                   : !refused.empty()           ? refused + " for a light among its casters"
                                   : settings.cube == Cube::Off ? "lights look one way, as asked for"
                                                                : "no light stands among its casters"};
}

}  // namespace

void add_all_around(const Scene& scene, const Settings& settings, Effects& effects) {
  add_impostors(scene, settings, effects);
  add_lights(scene, settings, effects);
}

}  // namespace caustics
