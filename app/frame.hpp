// From a request to a rendered frame: the steps that render, probe and digest share.
#pragma once
#include <memory>

#include "app/frame_options.hpp"
#include "pipeline/plan/framing.hpp"
#include "pipeline/plan/run_plan.hpp"
#include "pipeline/water/moving_water.hpp"

namespace caustics::app {

// A scene, completed, and what it calls for.
struct JudgedScene {
  Scene scene;
  Effects effects;
  const Camera* camera = nullptr;  // into `scene`
};

// Loads and completes the scene. Throws Error: BadInput, or WrongUsage for an unknown camera.
std::unique_ptr<JudgedScene> load_scene(const FrameRequest& request);

// What a frame occupies while it is rendered, in bytes: its textures as the software device holds
// them, and one more of the largest, read back.
std::uint64_t memory_needed(const FramePlan& plan);
// Throws Error (WrongUsage) when the frame needs more than three quarters of this machine's memory.
void check_memory(const FramePlan& plan, const Effects& effects);

// A frame on the device, ready to run. Everything it refers to it owns.
class RenderedFrame {
 public:
  RenderedFrame(const FrameRequest& request, std::unique_ptr<JudgedScene> judged,
                const PlanGoal& goal);

  // What moves is put where it is at this moment, seconds; at first it is at 0.
  void show(double seconds);
  std::vector<PassReport> run(const AfterPass& after = {});
  bool has(const std::string& texture) const { return plan_.find(texture) >= 0; }
  // The texels of a texture of the plan, by its full name or its index.
  Image read(const std::string& texture) const;
  Image read(int texture) const;
  // A pass of the plan with everything bound to it.
  PassRun prepare(const PlannedPass& pass) const;

  const Scene& scene() const { return judged_->scene; }
  const Effects& effects() const { return judged_->effects; }
  const Settings& settings() const { return settings_; }
  const FramePlan& plan() const { return plan_; }
  const std::vector<LightFrames>& frames() const { return frames_; }
  const FrameInputs& inputs() const { return inputs_; }
  const SceneOnDevice& on_device() const { return *on_device_; }
  Device& device() const { return *device_; }

 private:
  std::vector<LightFrames> fit_frames(const BackendRequest& backend);

  Settings settings_;
  std::unique_ptr<JudgedScene> judged_;
  FramePlan plan_;
  std::unique_ptr<Device> device_;
  std::unique_ptr<SceneOnDevice> on_device_;
  std::unique_ptr<MovingWater> water_;  // where the scene has any
  WaterReport water_report_;           // of what was shown last
  std::optional<double> shown_;        // the moment
  std::vector<LightFrames> frames_;
  std::unique_ptr<FrameTargets> targets_;
  FrameInputs inputs_;
};

}  // namespace caustics::app
