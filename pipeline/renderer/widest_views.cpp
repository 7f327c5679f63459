#include "pipeline/renderer/widest_views.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "pipeline/effects/backdrop.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/settings/settings.hpp"
#include "pipeline/views/all_around.hpp"
#include "pipeline/views/cone_range.hpp"
#include "pipeline/views/landing_window.hpp"

namespace caustics {

namespace {

// A window that nothing lies beside.
constexpr double kEverywhere = 1e12;

// Extent of something in window coordinates and along z.
struct Extents {
  glm::dvec2 lower{std::numeric_limits<double>::infinity()};
  glm::dvec2 upper{-std::numeric_limits<double>::infinity()};
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -std::numeric_limits<double>::infinity();
  bool empty() const { return lower.x > upper.x; }
  void add(const glm::dvec2& window, double z) {
    lower = glm::min(lower, window);
    upper = glm::max(upper, window);
    nearest = std::min(nearest, z);
    farthest = std::max(farthest, z);
  }
  void add(const Extents& other) {
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
    nearest = std::min(nearest, other.nearest);
    farthest = std::max(farthest, other.farthest);
  }
};

void add_point(Extents& extents, const View& axes, const glm::dvec3& p, double closest) {
  glm::dvec3 q = axes.coordinates(p);
  // What lies beside or behind a point light is seen at the widest angle.
  if (axes.perspective && q.z < closest) q.z = closest;
  glm::dvec2 w = axes.window(q);
  if (axes.perspective) w = glm::clamp(w, glm::dvec2(-kWidestTangent), glm::dvec2(kWidestTangent));
  extents.add(w, q.z);
}

Extents extents_of(const Mesh& mesh, const View& axes, double closest) {
  Extents extents;
  for (const Vertex& v : mesh.vertices) add_point(extents, axes, glm::dvec3(v.position), closest);
  return extents;
}

// `reach`: how far from the light anything lies. Coordinates are rounded to some ulps of it, and what is
// flat across the light has no depth of its own to spare.
void set_depth(View& view, double nearest, double farthest, double reach) {
  const double slack = std::max(1e-3 * (farthest - nearest), 4e-6 * std::fabs(reach));
  view.near = nearest - slack;
  view.far = farthest + slack;
  if (view.perspective) view.near = std::max(view.near, view.far * 1e-4);
}

struct LightExtents {
  View axes;
  Extents casters, receivers, occluders, panes, everything;
};

// What of the casters a spot light's cone can light, so that a narrow cone gets the whole grid.
void cut_to_cone(Extents& casters, const View& axes, const Light& light) {
  if (light.type != LightType::Spot || casters.empty()) return;
  for (int axis = 0; axis < 2; ++axis) {
    const std::optional<glm::dvec2> cone =
        cone_range(axes, axis, light.direction, static_cast<double>(light.outer_cone));
    if (!cone || cone->x >= casters.upper[axis] || cone->y <= casters.lower[axis]) continue;
    casters.lower[axis] = std::max(casters.lower[axis], cone->x);
    casters.upper[axis] = std::min(casters.upper[axis], cone->y);
  }
}

// The axes of a light that looks at a point.
View axes_towards(const Light& light, const glm::dvec3& target) {
  View axes = view_along(light.position, exact::normalise(target - light.position, light.direction));
  axes.perspective = true;
  return axes;
}

// The light's own: towards the casters, or along its rays.
View axes_of(const Scene& scene, const Effects& effects, const Light& light) {
  const Bounds bounds = bounds_of(scene);
  const double radius = std::max(bounds.radius(), 1e-9);
  if (light.type == LightType::Directional)
    return view_along(bounds.centre() - light.direction * (radius * 1.01), light.direction);
  Bounds casters;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (!is_caster(effects.surfaces[i].role) || light.emitter == static_cast<int>(i)) continue;
    const Bounds box = bounds_of(scene.meshes[i]);
    if (!light.lambertian || exact::dot(box.centre() - light.position, light.direction) > 0.0)
      casters.add(box);
  }
  glm::dvec3 target = casters.empty() ? bounds.centre() : casters.centre();
  // An emitter lights nothing that it turns away from.
  if (light.lambertian && exact::dot(target - light.position, light.direction) <= 0.0)
    target = light.position + light.direction * radius;
  View axes = axes_towards(light, target);
  axes.near = 1e-3 * std::max(exact::length(target - light.position), 1e-3 * radius);
  return axes;
}

// `axes`: what lies nearer than its near plane is seen as if on it, at the widest angle.
LightExtents measure(const Scene& scene, const Effects& effects, int number, const View& axes) {
  const Light& light = scene.lights[static_cast<std::size_t>(number)];
  LightExtents result;
  result.axes = axes;
  const double closest = axes.perspective ? axes.near : 0.0;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (light.emitter == static_cast<int>(i)) continue;
    const Extents extents = extents_of(scene.meshes[i], result.axes, closest);
    result.everything.add(extents);
    const Role role = effects.surfaces[i].role;
    if (tints_light(effects.surfaces[i])) result.panes.add(extents);
    if (is_caster(role)) {
      result.casters.add(extents);
      if (effects.lights[static_cast<std::size_t>(number)].casters_shadow) result.occluders.add(extents);
    } else if (role == Role::Receiver) {
      result.receivers.add(extents);
      if (!is_backdrop(scene, i, light)) result.occluders.add(extents);
    }
  }
  cut_to_cone(result.casters, result.axes, light);
  return result;
}

LightViews through_windows(const LightExtents& extents, const Effects& effects, int grid) {
  LightViews views{extents.axes, extents.axes, extents.axes, extents.axes,
                   extents.axes, 0.0,          extents.axes, {}};
  const Extents& shadow = extents.occluders.empty() ? extents.everything : extents.occluders;
  const double reach = extents.everything.farthest;
  if (!shadow.empty()) {
    set_window(views.shadow, {shadow.lower, shadow.upper}, 0.01);
    set_depth(views.shadow, extents.everything.nearest, reach, reach);
  }
  if (!extents.panes.empty()) {
    set_window(views.panes, {extents.panes.lower, extents.panes.upper}, 0.01);
    set_depth(views.panes, extents.everything.nearest, reach, reach);
  }
  if (extents.casters.empty()) return views;
  set_window(views.caster, {extents.casters.lower, extents.casters.upper}, 4.0 / grid);
  set_depth(views.caster, extents.everything.nearest, extents.casters.farthest, reach);
  Extents all = extents.casters;
  if (!extents.receivers.empty()) all.add(extents.receivers);
  set_window(views.receiver, {all.lower, all.upper}, 0.01);
  set_depth(views.receiver, all.nearest, all.farthest, reach);
  views.casters_nearest = extents.casters.nearest;
  views.column = views.caster;
  if (!effects.mirrors.active && !effects.reflections.active && !effects.further_surfaces.active) {
    views.column.window_lower = glm::dvec2(-kEverywhere);
    views.column.window_upper = glm::dvec2(kEverywhere);
  }
  views.caustic = views.receiver;
  return views;
}

}  // namespace

// The views of where the light lands look another way than that of the casters: everything may be there, and
// nothing stands between the light and the casters.
void turn_to_landings(LightViews& views, const LightExtents& turned) {
  if (turned.receivers.empty()) return;
  views.receiver = turned.axes;
  set_window(views.receiver, {turned.receivers.lower, turned.receivers.upper}, 0.01);
  set_depth(views.receiver, turned.receivers.nearest, turned.receivers.farthest, turned.everything.farthest);
  views.caustic = views.receiver;
  views.column = views.receiver;
  views.casters_nearest = 0.0;
}

LightViews widest_views(const Scene& scene, const Effects& effects, const Settings& settings, int number) {
  const auto index = static_cast<std::size_t>(number);
  if (!effects.lights[index].all_around.empty())
    return views_all_around(scene, effects, settings, scene.lights[index]);
  const Light& light = scene.lights[index];
  const View axes = axes_of(scene, effects, light);
  LightViews views = through_windows(measure(scene, effects, number, axes), effects, settings.grid);
  if (const glm::dvec3 looks = effects.lights[index].looks; looks != glm::dvec3(0.0)) {
    View turned = axes_towards(light, light.position + looks);
    turned.near = axes.near;
    turn_to_landings(views, measure(scene, effects, number, turned));
  }
  return views;
}

}  // namespace caustics
