#include "pipeline/renderer/frame_renderer.hpp"
#include "pipeline/effects/branches.hpp"

#include <algorithm>

#include "pipeline/effects/cascades.hpp"
#include "pipeline/effects/dim_lights.hpp"
#include "pipeline/effects/drawn_sizes.hpp"
#include "pipeline/effects/further_surfaces.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/measure/light_groups.hpp"
#include "pipeline/measure/light_shares.hpp"
#include "pipeline/renderer/picture_sides.hpp"
#include "pipeline/views/cascades.hpp"
#include "pipeline/views/sub_pixel.hpp"

namespace caustics {

namespace {

// A pilot follows one sample of a light with a size, and those that are drawn for all: the others' light
// lands on the same receivers.
void share_among_samples(const Scene& scene, Effects& effects) {
  for (const FurtherShare& found : effects.further_shares) {
    const int source = scene.lights[static_cast<std::size_t>(found.light)].source;
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
      if (source >= 0 && scene.lights[i].source == source && !effects.lights[i].size_is_drawn)
        effects.lights[i].lit = found.lit;
  }
}

// Effects, a pilot's views, what it found, the plan: in this order, here and nowhere else. The views of
// moving water hold whatever the waves do, so that maps and shadows do not crawl.
PlannedFrame planned(Scene& scene, const Settings& asked, const Registry& registry, LightPilot& pilot,
                     const View* camera, const PlanGoal& goal, Effect Effects::*without = nullptr) {
  PlannedFrame frame;
  std::optional<View> seen;
  if (camera) seen = around_samples(*camera, samples_a_pixel(asked), asked.width, asked.height);
  std::vector<FurtherShare> shares;
  std::optional<std::vector<LightShare>> of_lights;
  const auto fit = [&](const Settings& settings, std::vector<LandingSurvey>* surveys) {
    frame.settings = settings;
    frame.effects = effects_of(scene, settings, seen ? &*seen : nullptr);
    if (without) frame.effects.*without = {false, "left out on request"};
    if (!of_lights) {
      of_lights = light_shares(scene, frame.effects, static_cast<double>(settings.least_light));
      group_lights(scene, frame.effects, settings.most_lights, *of_lights);
    }
    frame.effects = with_drawn_sizes(with_dim_lights(std::move(frame.effects), scene, settings, *of_lights),
                                     scene, settings);
    if (shares.empty() && frame.effects.further_surfaces.reason.empty())
      shares = pilot.further_shares(frame.effects, settings, camera);
    frame.effects = with_further_surfaces(std::move(frame.effects), settings, shares);
    share_among_samples(scene, frame.effects);
    frame.views = frame.effects.water_waves.active
                      ? fit_moving_views(scene, pilot.device(), frame.effects, settings, registry)
                      : pilot.fit(frame.effects, frame.settings, surveys);
  };
  const bool chooses = camera && chooses_sides(scene, asked);
  std::vector<LandingSurvey> surveys;
  fit(with_least_sides(asked), chooses ? &surveys : nullptr);
  if (chooses && !all_light_is_spread(frame.effects)) {
    const Settings chosen = with_sides_for_picture(
        frame.settings, scene, frame.effects.further_surfaces.active, surveys, frame.views, *camera);
    if (chosen.map != frame.settings.map) fit(chosen, nullptr);
  }
  const std::vector<PilotFinding> findings = findings_of(frame.views, frame.effects, camera);
  frame.effects = with_findings(std::move(frame.effects), frame.settings, findings);
  frame.plan = make_plan(scene, frame.effects, frame.settings, registry, goal);
  return frame;
}

void measure_memory(PlannedFrame& frame) {
  return_freed_memory();
  frame.taken = resident_memory();
}

// Nothing where there is no camera.
std::optional<View> camera_view(const Scene& scene, const Camera* camera, const Settings& settings) {
  if (!camera && !scene.cameras.empty()) camera = &scene.cameras.front();
  if (!camera) return {};
  return view_of(*camera, settings.width, settings.height, bounds_of(scene));
}

}  // namespace

PlannedFrame plan_frame(Scene& scene, const Settings& settings, const Registry& registry, Device& device,
                        const PlanGoal& goal, const Camera* camera) {
  const SceneOnDevice on_device(scene, effects_of(scene, settings), device);
  LightPilot pilot(on_device, registry);
  const std::optional<View> view = camera_view(scene, camera, settings);
  PlannedFrame frame = planned(scene, settings, registry, pilot, view ? &*view : nullptr, goal);
  measure_memory(frame);
  return frame;
}

FrameRenderer::FrameRenderer(Scene& scene, const Settings& settings, const Registry& registry, Device& device,
                             FrameOptions options)
    : scene_(scene),
      asked_(std::make_unique<Settings>(settings)),
      registry_(registry),
      device_(device),
      options_(std::move(options)) {
  const Effects effects = effects_of(scene_, *asked_);
  on_device_ = std::make_unique<SceneOnDevice>(scene_, effects, device_);
  if (options_.pilot) on_pilot_ = std::make_unique<SceneOnDevice>(scene_, effects, *options_.pilot);
  pilot_ = std::make_unique<LightPilot>(on_pilot(), registry_);
  inputs_.settings = &frame_.settings;
  inputs_.effects = &frame_.effects;
  inputs_.views = &frame_.views;
  inputs_.exposure = options_.exposure
                         ? *options_.exposure
                         : exposure_of(scene_, *asked_, camera_view(scene_, options_.camera, *asked_),
                                       {options_.pilot ? *options_.pilot : device_, registry_});
  judge_and_plan();
  if (effects.water_waves.active) water_ = std::make_unique<MovingWater>(scene_, device_, registry_);
  make_targets();
  show_waters(options_.seconds);
}

FrameRenderer::~FrameRenderer() = default;

// Waters are at rest meanwhile, so that a moment's plan does not depend on those before it.
void FrameRenderer::judge_and_plan() {
  if (water_) water_->show_level(0.0);
  if (!scene_.waters.empty()) {
    const Effects undecided = effects_of(scene_, *asked_);
    for (SceneOnDevice* on_device : {on_device_.get(), on_pilot_.get()}) {
      if (!on_device) continue;
      on_device->meet_waters(undecided);
      if (shown_) on_device->renew_waters(false);
    }
  }
  const std::optional<View> camera = camera_view(scene_, options_.camera, *asked_);
  frame_ = planned(scene_, *asked_, registry_, *pilot_, camera ? &*camera : nullptr, options_.goal,
                   options_.without);
  for (SceneOnDevice* on_device : {on_device_.get(), on_pilot_.get()})
    if (on_device) on_device->meet_waters(frame_.effects);
  done_ = 0;
  inputs_.camera = camera.value_or(View{});
}

void FrameRenderer::make_targets() {
  targets_.reset();
  if (options_.accept) {
    measure_memory(frame_);
    options_.accept(frame_);
  }
  targets_ = std::make_unique<FrameTargets>(frame_.plan, device_);
}

void FrameRenderer::moved(const std::vector<int>& meshes, const Camera* camera) {
  options_.camera = camera;
  on_device_->update(meshes);
  if (on_pilot_) on_pilot_->update(meshes);
  const std::vector<PlannedTexture> before = std::move(frame_.plan.textures);
  judge_and_plan();
  shown_.reset();  // fitting leaves the waters at rest
  // Other textures only where the moment calls for other effects.
  if (frame_.plan.textures != before) make_targets();
}

void FrameRenderer::show_waters(double seconds) {
  if (!water_ || shown_ == seconds) return;
  const bool with_state = std::any_of(frame_.plan.passes.begin(), frame_.plan.passes.end(),
                                      [](const PlannedPass& pass) { return pass.water >= 0; });
  water_report_ = water_->show(seconds, with_state);
  on_device_->renew_waters(with_state);
  if (on_pilot_) on_pilot_->renew_waters(false);
  shown_ = seconds;
}

std::vector<PassReport> FrameRenderer::run(const AfterPass& after) {
  std::vector<PassReport> reports = water_report_;
  const AfterPass watched = [&](const PlannedPass& pass, const PassResult& result, std::size_t done,
                                std::size_t total) {
    done_ = static_cast<int>(done) - 1;
    return !after || after(pass, result, done, total);
  };
  for (PassReport& report : run_plan(frame_.plan, registry_, *on_device_, *targets_, inputs_, watched))
    reports.push_back(std::move(report));
  return reports;
}

TextureId FrameRenderer::held(int texture) const {
  const PlannedTexture& planned = frame_.plan.textures[static_cast<std::size_t>(texture)];
  if (!planned.external && planned.until < done_)
    throw Error(ExitCode::InternalError,
                "texture '" + planned.name + "' is not kept for so long; name it in the goal");
  return planned.external ? on_device_->external(planned.name) : (*targets_)[texture];
}

TextureId FrameRenderer::held(const std::string& texture) const {
  const int index = frame_.plan.find(texture);
  if (index < 0) throw Error(ExitCode::InternalError, "the frame has no texture '" + texture + "'");
  return held(index);
}

Image FrameRenderer::read(int texture) const { return device_.read_back(held(texture)); }
Image FrameRenderer::read(const std::string& texture) const { return device_.read_back(held(texture)); }
ImageView FrameRenderer::look_at(const std::string& texture) const { return device_.look_at(held(texture)); }

PassRun FrameRenderer::prepare(const PlannedPass& pass) const {
  return prepare_pass(frame_.plan, pass, registry_, *on_device_, *targets_, inputs_);
}

}  // namespace caustics
