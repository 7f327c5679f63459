// From a request to a rendered frame: the steps that render, probe and digest share.
#pragma once
#include <functional>
#include <memory>

#include "pipeline/measure/frame_memory.hpp"
#include "pipeline/renderer/frame_renderer.hpp"

namespace caustics::app {

class LoadedScene;
struct BackendRequest;
struct FrameRequest;

// The views of every light are fitted on it, whatever device draws.
std::unique_ptr<Device> make_pilot_device(const BackendRequest& backend);

// Whether a planned frame fits into the memory: `plan` says it, RenderedFrame acts on it.
struct MemoryJudgement {
  std::uint64_t needed = 0;  // bytes
  MemoryBudget budget;
  std::string refusal;  // empty: it fits
};
// FrameCost::outputs of a frame that is planned. `device_is_made`: what the device takes before it draws is
// taken.
using OutputBytes = std::function<std::uint64_t(const PlannedFrame& frame)>;
MemoryJudgement judge_memory(const FrameRequest& request, const Scene& scene, const PlannedFrame& frame,
                             bool device_is_made, const OutputBytes& outputs = {});

// Throws Error (WrongUsage) where the scene's waters would have to make more steps from rest to this moment
// than LoadOptions::max_water_updates allows before time 0.
void check_water_work(const Scene& scene, double seconds);

// A frame on the device, ready to run; one after the other where the scene moves. Everything it refers
// to it owns.
class RenderedFrame {
 public:
  // `loaded`: may serve several frames one after the other, of requests that differ neither in what is loaded
  // nor in camera and exposure. `without`: FrameOptions::without.
  RenderedFrame(const FrameRequest& request, std::shared_ptr<LoadedScene> loaded, const PlanGoal& goal,
                Effect Effects::*without = nullptr, OutputBytes outputs = {});
  RenderedFrame(const RenderedFrame&) = delete;
  RenderedFrame& operator=(const RenderedFrame&) = delete;
  ~RenderedFrame();

  // Stops after a pass when `after` says so.
  std::vector<PassReport> run(const AfterPass& after = {});
  // The scene at that moment of its animation, ready to run; the device and what is on it are kept. The
  // images are those of a frame made for that moment alone.
  void move_to(double seconds);

  bool moves() const;
  bool has(const std::string& texture) const { return renderer_->has(texture); }
  template <class NameOrIndex>
  Image read(const NameOrIndex& texture) const {
    return renderer_->read(texture);
  }
  ImageView look_at(const std::string& texture) const { return renderer_->look_at(texture); }
  PassRun prepare(const PlannedPass& pass) const { return renderer_->prepare(pass); }

  const LoadedScene& loaded() const { return *loaded_; }
  const Scene& scene() const { return renderer_->scene(); }
  const Effects& effects() const { return renderer_->effects(); }
  const Settings& settings() const { return renderer_->settings(); }
  // Grid vertices a side of a light (by Scene::lights).
  int grid_of(int light) const;
  const FramePlan& plan() const { return renderer_->plan(); }
  const std::vector<LightViews>& views() const { return renderer_->views(); }
  const FrameInputs& inputs() const { return renderer_->inputs(); }
  const SceneOnDevice& on_device() const { return renderer_->on_device(); }
  const SceneOnDevice& on_pilot() const { return renderer_->on_pilot(); }
  const Registry& registry() const { return renderer_->registry(); }
  Device& device() const { return *device_; }
  const MemoryJudgement& memory() const { return memory_; }

 private:
  std::shared_ptr<LoadedScene> loaded_;
  std::unique_ptr<Device> device_, pilot_device_;
  MemoryJudgement memory_;
  std::unique_ptr<FrameRenderer> renderer_;
};

}  // namespace caustics::app
