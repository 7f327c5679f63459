// From a request to a rendered frame: the steps that render, probe and digest share.
#pragma once
#include <memory>

#include "app/judged_scene.hpp"
#include "pipeline/renderer/light_pilot.hpp"
#include "pipeline/renderer/run_plan.hpp"
#include "pipeline/renderer/moving_water.hpp"

namespace caustics::app {

// What a frame occupies while it is rendered, in bytes: its textures as the software device holds
// them, and one more of the largest, read back.
std::uint64_t memory_needed(const FramePlan& plan);
// Throws Error (WrongUsage) when the frame needs more than three quarters of this machine's memory.
void check_memory(const FramePlan& plan, const Effects& effects);
// The same of so many bytes; `advice`: what to lower.
void check_memory(std::uint64_t needed, const std::string& advice);

// The views of every light, fitted on a software device of its own. Leaves waters at rest.
std::vector<LightViews> fit_views(JudgedScene& judged, const FrameRequest& request);

// A frame on the device, ready to run; one after the other where the scene moves. Everything it refers
// to it owns.
class RenderedFrame {
 public:
  RenderedFrame(const FrameRequest& request, std::unique_ptr<JudgedScene> judged,
                const PlanGoal& goal);

  std::vector<PassReport> run(const AfterPass& after = {});
  bool has(const std::string& texture) const { return plan_.find(texture) >= 0; }
  // The texels of a texture of the plan, by its full name or its index.
  Image read(const std::string& texture) const;
  Image read(int texture) const;
  // A pass of the plan with everything bound to it.
  PassRun prepare(const PlannedPass& pass) const;

  // The scene at that moment of its animation, ready to run; the device and what is on it are kept. The
  // images are those of a frame made for that moment alone.
  void move_to(double seconds);

  const Scene& scene() const { return judged_->scene(); }
  const Effects& effects() const { return judged_->effects(); }
  bool moves() const { return judged_->moves() || water_ != nullptr; }
  const Settings& settings() const { return settings_; }
  const FramePlan& plan() const { return plan_; }
  const std::vector<LightViews>& views() const { return views_; }
  const FrameInputs& inputs() const { return inputs_; }
  const SceneOnDevice& on_device() const { return *on_device_; }
  Device& device() const { return *device_; }

 private:
  void plan_frame();
  void make_fitter(const BackendRequest& backend);
  void fit();
  void move_animation(double seconds);
  void show_waters(double seconds);

  Settings settings_;
  std::unique_ptr<JudgedScene> judged_;
  PlanGoal goal_;
  FramePlan plan_;
  std::unique_ptr<Device> device_;
  std::unique_ptr<SceneOnDevice> on_device_;
  // Only where another device than the software device draws.
  std::unique_ptr<Device> fitting_device_;
  std::unique_ptr<SceneOnDevice> fitting_scene_;
  std::unique_ptr<LightFitter> fitter_;
  std::unique_ptr<MovingWater> water_;  // where the scene has any
  WaterReport water_report_;           // of what was shown last
  std::optional<double> shown_;         // the moment of the waters
  std::vector<LightViews> views_;
  std::unique_ptr<FrameTargets> targets_;
  FrameInputs inputs_;
};

}  // namespace caustics::app
