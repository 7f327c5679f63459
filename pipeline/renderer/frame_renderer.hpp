// From a scene to frames of it: the one place where it is judged what the scene calls for, the lights' views
// are fitted, the passes planned, run and read back.
#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "pipeline/gpu/process_memory.hpp"
#include "pipeline/renderer/light_pilot.hpp"
#include "pipeline/renderer/moving_water.hpp"
#include "pipeline/renderer/run_plan.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

// What a frame is before any of its textures exist.
struct PlannedFrame {
  Settings settings;  // as asked for, and with sides that were left to the frame
  Effects effects;
  std::vector<LightViews> views;  // by Scene::lights
  FramePlan plan;
  ResidentMemory taken;  // by the process, when the frame was planned
};

// What a FrameRenderer would do, without doing it. `pilot`: the software device, on which the lights' views
// are fitted. `camera`: null: the scene's first. Leaves waters at rest.
PlannedFrame plan_frame(Scene& scene, const Settings& settings, const Registry& registry, Device& pilot,
                        const PlanGoal& goal = {}, const Camera* camera = nullptr);

struct FrameOptions {
  PlanGoal goal{};                     // the images that are wanted; empty: all that the effects call for
  const Camera* camera = nullptr;      // null: the scene's first; a scene without cameras has no picture
  std::optional<Exposure> exposure{};  // none: the scene's own, as the camera shows it (exposure_of)
  double seconds = 0.0;                // the moment that the scene's waters are shown at
  Effect Effects::*without = nullptr;  // left out although the scene calls for it
  // The device on which the lights' views are fitted where `device` is not the software device, so that every
  // device draws the same frames; null: the same device.
  Device* pilot = nullptr;
  // Sees the plan before its textures are made, and may refuse it by throwing.
  std::function<void(const PlannedFrame&)> accept{};
};

class FrameRenderer {
 public:
  // All must outlive it, the options' camera and pilot too. The scene is complete (complete_scene); its
  // waters move. Throws Error as the passes, the device and the callbacks do.
  FrameRenderer(Scene& scene, const Settings& settings, const Registry& registry, Device& device,
                FrameOptions options = {});
  FrameRenderer(const FrameRenderer&) = delete;
  FrameRenderer& operator=(const FrameRenderer&) = delete;
  ~FrameRenderer();

  // Draws the frame. Moving water's steps come first in the reports.
  std::vector<PassReport> run(const AfterPass& after = {});

  // The scene stands at another moment: these meshes have moved, and lights and cameras may have. Only what
  // the moment calls for anew is made anew; the images are those of a renderer made for that moment alone.
  void moved(const std::vector<int>& meshes, const Camera* camera);
  // Moves the scene's waters to a moment, seconds.
  void show_waters(double seconds);

  bool has(const std::string& texture) const { return frame_.plan.find(texture) >= 0; }
  // The texels of a texture of the plan, by its full name or its index; from the callback of run() too.
  // Throws Error (InternalError) for other names, and where it no longer is to hold its contents.
  Image read(const std::string& texture) const;
  Image read(int texture) const;
  // Likewise, to look at until the next pass runs.
  ImageView look_at(const std::string& texture) const;
  // A pass of the plan with everything bound to it, as run() hands it to the device. What it reads is there
  // until the next pass runs, and longer where the goal keeps it.
  PassRun prepare(const PlannedPass& pass) const;

  const Scene& scene() const { return scene_; }
  // With the sides that were chosen.
  const Settings& settings() const { return frame_.settings; }
  const Effects& effects() const { return frame_.effects; }
  const FramePlan& plan() const { return frame_.plan; }
  const std::vector<LightViews>& views() const { return frame_.views; }
  const FrameInputs& inputs() const { return inputs_; }
  const SceneOnDevice& on_device() const { return *on_device_; }
  // Likewise, on the device on which the lights' views are fitted.
  const SceneOnDevice& on_pilot() const { return on_pilot_ ? *on_pilot_ : *on_device_; }
  const Registry& registry() const { return registry_; }
  Device& device() const { return device_; }
  bool has_waters() const { return water_ != nullptr; }

 private:
  // A texture of the plan, if it still is to hold its contents.
  TextureId held(int texture) const;
  TextureId held(const std::string& texture) const;
  void judge_and_plan();
  void make_targets();

  Scene& scene_;
  std::unique_ptr<const Settings> asked_;
  const Registry& registry_;
  Device& device_;
  FrameOptions options_;
  std::unique_ptr<SceneOnDevice> on_device_;
  std::unique_ptr<SceneOnDevice> on_pilot_;  // only where another device draws
  std::unique_ptr<LightPilot> pilot_;
  PlannedFrame frame_;
  std::unique_ptr<MovingWater> water_;  // where the scene has any
  WaterReport water_report_;            // of what was shown last
  std::optional<double> shown_;         // the moment of the waters
  std::unique_ptr<FrameTargets> targets_;
  FrameInputs inputs_;
  int done_;  // the pass of the plan that ran last; judge_and_plan begins anew
};

}  // namespace caustics
