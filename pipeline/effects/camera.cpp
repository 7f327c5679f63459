#include "pipeline/effects/camera.hpp"

#include <algorithm>

#include "pipeline/effects/expectations.hpp"
#include "pipeline/effects/surface_role.hpp"
#include "pipeline/scene/visibility.hpp"

namespace caustics {

namespace {

std::string counted(std::size_t n, const std::string& singular) {
  return std::to_string(n) + " " + singular + (n == 1 ? "" : "s");
}

void add_seen_casters(const Scene& scene, const View* camera, Effects& effects) {
  std::size_t refractors = 0, mirrors = 0, panes = 0, hidden = 0;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Role role = effects.surfaces[i].role;
    if (!is_on_the_way(effects.surfaces[i])) continue;
    // Waves may carry water anywhere.
    const bool seen = !camera || effects.water_waves.active || may_see(*camera, bounds_of(scene.meshes[i]));
    (!seen ? hidden : role == Role::Mirror ? mirrors : role == Role::ThinPane ? panes : refractors) += 1;
  }
  const bool any = refractors + mirrors + panes > 0;
  effects.seen_casters = {any, any ? counted(refractors, "refractor") + " to look through, " +
                                         counted(mirrors, "mirror") + " to look into" +
                                         (panes > 0 ? ", " + counted(panes, "pane") + " for both" : "")
                               : hidden > 0 ? "no refractor and no mirror in the camera's view"
                                            : "no refractor to look through, no mirror to look into"};
  effects.seen_panes = {panes > 0,
                        panes > 0 ? counted(panes, "thin pane") + " to look through" : "none in view"};
}

bool is_black(const Material& material) {
  return !(std::max({material.base_color.x, material.base_color.y, material.base_color.z}) > 0.0f);
}

void add_reflecting_receivers(const Scene& scene, Effects& effects) {
  std::size_t reflecting = 0;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (has_diffuse(effects.surfaces[i]) &&
        !is_black(scene.materials[static_cast<std::size_t>(scene.meshes[i].material)]))
      ++reflecting;
  effects.reflecting_receivers = {
      reflecting > 0, reflecting > 0             ? counted(reflecting, "surface") + " with colour"
                      : effects.receivers.active ? "all diffuse surfaces are black: no light shows on them"
                                                 : "no surface is diffuse"};
}

std::vector<std::size_t> seen_receivers(const Scene& scene, const View* camera, const Effects& effects) {
  // Glass shows all that there is.
  const bool all = !camera || effects.seen_casters.active;
  std::vector<std::size_t> receivers;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (has_diffuse(effects.surfaces[i]) && (all || may_see(*camera, bounds_of(scene.meshes[i]))))
      receivers.push_back(i);
  return receivers;
}

std::string why_it_lights_nothing(const Scene& scene, const Light& light,
                                  const std::vector<std::size_t>& receivers) {
  std::string reason = "no diffuse surface in view";
  for (const std::size_t i : receivers) {
    reason = why_not_lit(scene, light, i);
    if (reason.empty()) break;
  }
  return reason;
}

}  // namespace

void add_camera(const Scene& scene, const View* camera, Effects& effects) {
  add_seen_casters(scene, camera, effects);
  add_reflecting_receivers(scene, effects);
  const std::vector<std::size_t> receivers = seen_receivers(scene, camera, effects);
  std::string first;
  bool any = false;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    // A medium shows the light on its way.
    // So do glass and metal, where there is nothing else for it to light.
    const bool is_mirrored = receivers.empty() && effects.seen_casters.active && effects.highlights.active;
    if ((!effects.medium.active && !is_mirrored) || is_dark(light))
      effects.lights[i].lights_nothing = why_it_lights_nothing(scene, light, receivers);
    any |= has_effect(effects, static_cast<int>(i));
    if (i == 0)
      first = quoted_name("light", source_of(scene, 0).name, 0) + ": " + effects.lights[0].lights_nothing;
  }
  if (effects.light.active && !any) effects.light = {false, first};
}

}  // namespace caustics
