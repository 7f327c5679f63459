#include "pipeline/renderer/moving_water.hpp"

#include <algorithm>

#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

// Moments to look at, in plop intervals since the scene's time 0: waves of a few plops, on different ways.
constexpr double kMoments[] = {1.5, 3.25, 6.5};

void widen(View& view, const View& other) {
  view.window_lower = glm::min(view.window_lower, other.window_lower);
  view.window_upper = glm::max(view.window_upper, other.window_upper);
  view.near = std::min(view.near, other.near);
  view.far = std::max(view.far, other.far);
}

void widen(LightViews& views, const LightViews& other) {
  widen(views.caster, other.caster);
  widen(views.receiver, other.receiver);
  widen(views.caustic, other.caustic);
  widen(views.shadow, other.shadow);
  widen(views.panes, other.panes);
  widen(views.column, other.column);
  views.casters_nearest = std::min(views.casters_nearest, other.casters_nearest);
}

}  // namespace

MovingWater::MovingWater(Scene& scene, Device& device, const Registry& registry) : scene_(scene) {
  for (const Water& water : scene.waters)
    waters_.push_back(std::make_unique<Moving>(water, mesh_of(water), device, water_pass(registry)));
}

WaterReport MovingWater::show(double seconds, bool with_state) {
  WaterReport reports;
  for (std::size_t i = 0; i < waters_.size(); ++i) {
    Water& water = scene_.waters[i];
    WaterSimulation& simulation = waters_[i]->simulation;
    const PassResult earlier = simulation.work();
    simulation.advance_to(seconds);
    const double lead = static_cast<double>(simulation.steps()) * water.step - water.since_rest(seconds);
    waters_[i]->surface.displace(simulation.state(), lead, mesh_of(water));
    water.last_step = simulation.steps() - 1;
    if (with_state) water.before = simulation.before();
    PassResult work = simulation.work();
    work.vertices -= earlier.vertices;
    work.primitives -= earlier.primitives;
    work.fragments -= earlier.fragments;
    work.milliseconds -= earlier.milliseconds;
    work.processor_milliseconds -= earlier.processor_milliseconds;
    reports.push_back({std::string(kWaterStep) + "[" + water.name + "]", work});
  }
  return reports;
}

void MovingWater::show_level(double share) {
  for (std::size_t i = 0; i < waters_.size(); ++i)
    waters_[i]->surface.level(share * scene_.waters[i].highest, mesh_of(scene_.waters[i]));
}

std::vector<LightViews> fit_moving_views(Scene& scene, Device& device, const Effects& effects,
                                         const Settings& settings, const Registry& registry) {
  MovingWater moving(scene, device, registry);
  std::vector<LightViews> views;
  Settings uncascaded = settings;
  uncascaded.cascades = false;
  const auto look = [&] {
    const std::vector<LightViews> found =
        fit_light_views(SceneOnDevice(scene, effects, device), effects, uncascaded, registry);
    if (views.empty()) views = found;
    for (std::size_t i = 0; i < views.size(); ++i) widen(views[i], found[i]);
  };
  for (const double share : {-1.0, 1.0}) {
    moving.show_level(share);
    look();
  }
  double interval = 0.0;
  for (const Water& water : scene.waters) interval = std::max(interval, water.settings.interval);
  for (const double moment : kMoments) {
    moving.show(moment * interval, false);
    look();
  }
  return views;
}

}  // namespace caustics
