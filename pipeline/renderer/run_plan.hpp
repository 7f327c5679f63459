// Running a plan on a device: its targets and the loop over its passes.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "pipeline/gpu/owned.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/renderer/exposure.hpp"
#include "pipeline/renderer/scene_on_device.hpp"

namespace caustics {

// The memory of the textures a plan writes, made once and used frame after frame.
class FrameTargets {
 public:
  FrameTargets(const FramePlan& plan, Device& device);
  // Puts a texture that holds the image in the place of a planned one.
  void replace(int index, const Image& image);
  // By a planned texture's index.
  TextureId operator[](int index) const { return memory_[place_of(index)].id(); }

 private:
  std::size_t place_of(int index) const { return places_[static_cast<std::size_t>(index)]; }

  Device& device_;
  std::vector<OwnedTexture> memory_;
  std::vector<std::size_t> places_;  // in `memory_`, by planned texture
};

// What a frame is drawn from besides the scene.
struct FrameInputs {
  const Settings* settings = nullptr;
  const Effects* effects = nullptr;
  const std::vector<LightViews>* views = nullptr;  // by Scene::lights
  View camera;
  Exposure exposure{};
};

struct PassReport {
  std::string label;
  PassResult result;
};

// Called after each pass; returning false stops the frame (Error Interrupted is thrown by run_plan, as where
// work is asked to stop: pipeline/gpu/interrupt.hpp).
using AfterPass =
    std::function<bool(const PlannedPass&, const PassResult&, std::size_t done, std::size_t total)>;

std::vector<PassReport> run_plan(const FramePlan& plan, const Registry& registry, const SceneOnDevice& scene,
                                 const FrameTargets& targets, const FrameInputs& inputs,
                                 const AfterPass& after = {});

// One pass of the plan, bound and ready for a device: what run_plan executes, for tools such as the
// probe that want a pass's inputs.
PassRun prepare_pass(const FramePlan& plan, const PlannedPass& pass, const Registry& registry,
                     const SceneOnDevice& scene, const FrameTargets& targets, const FrameInputs& inputs);

}  // namespace caustics
