#include "pipeline/water/moving_water.hpp"

#include <algorithm>

namespace caustics {

namespace {

// Moments to look at, in plop intervals since the scene's time 0: waves of a few plops, on different ways.
constexpr double kMoments[] = {1.5, 3.25, 6.5};

void widen(Frame& frame, const Frame& other) {
  frame.window_lower = glm::min(frame.window_lower, other.window_lower);
  frame.window_upper = glm::max(frame.window_upper, other.window_upper);
  frame.near = std::min(frame.near, other.near);
  frame.far = std::max(frame.far, other.far);
}

void widen(LightFrames& frames, const LightFrames& other) {
  widen(frames.caster, other.caster);
  widen(frames.receiver, other.receiver);
  widen(frames.caustic, other.caustic);
  widen(frames.shadow, other.shadow);
  widen(frames.panes, other.panes);
  widen(frames.column, other.column);
  frames.casters_nearest = std::min(frames.casters_nearest, other.casters_nearest);
}

}  // namespace

MovingWater::MovingWater(Scene& scene, Device& device, const Registry& registry) : scene_(scene) {
  for (const Water& water : scene.waters)
    waters_.push_back(std::make_unique<Moving>(water, mesh_of(water), device, water_pass(registry)));
}

WaterReport MovingWater::show(double seconds, bool with_state, const Breath& breath) {
  WaterReport reports;
  for (std::size_t i = 0; i < waters_.size(); ++i) {
    Water& water = scene_.waters[i];
    WaterSimulation& simulation = waters_[i]->simulation;
    const PassResult earlier = simulation.work();
    simulation.advance_to(seconds, breath);
    const double lead = static_cast<double>(simulation.steps()) * water.step - water.since_rest(seconds);
    waters_[i]->surface.displace(simulation.state(), lead, mesh_of(water));
    water.last_step = simulation.steps() - 1;
    if (with_state) water.before = simulation.before();
    PassResult work = simulation.work();
    work.vertices -= earlier.vertices;
    work.primitives -= earlier.primitives;
    work.fragments -= earlier.fragments;
    work.milliseconds -= earlier.milliseconds;
    reports.push_back({std::string(kWaterStep) + "[" + water.name + "]", work});
  }
  return reports;
}

void MovingWater::show_level(double share) {
  for (std::size_t i = 0; i < waters_.size(); ++i)
    waters_[i]->surface.level(share * scene_.waters[i].highest, mesh_of(scene_.waters[i]));
}

std::vector<LightFrames> fit_moving_frames(Scene& scene, Device& device, const Effects& effects,
                                           const Settings& settings, const Registry& registry,
                                           const Breath& breath) {
  MovingWater moving(scene, device, registry);
  std::vector<LightFrames> frames;
  Settings uncascaded = settings;
  uncascaded.cascades = false;
  const auto look = [&] {
    const std::vector<LightFrames> found =
        fit_light_frames(SceneOnDevice(scene, effects, device), effects, uncascaded, registry);
    if (frames.empty()) frames = found;
    for (std::size_t i = 0; i < frames.size(); ++i) widen(frames[i], found[i]);
  };
  for (const double share : {-1.0, 1.0}) {
    moving.show_level(share);
    look();
  }
  double interval = 0.0;
  for (const Water& water : scene.waters) interval = std::max(interval, water.settings.interval);
  for (const double moment : kMoments) {
    moving.show(moment * interval, false, breath);
    look();
  }
  moving.show_level(0.0);
  return frames;
}

}  // namespace caustics
