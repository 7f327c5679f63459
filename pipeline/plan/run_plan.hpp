// Running a plan on a device: uploads, targets, the loop over the passes.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/gpu/device.hpp"
#include "pipeline/plan/frame_plan.hpp"

namespace caustics {

// A scene's meshes, material textures and tables on a device. Keeps references to both.
class SceneOnDevice {
 public:
  SceneOnDevice(const Scene& scene, const Effects& effects, Device& device);
  ~SceneOnDevice();
  SceneOnDevice(const SceneOnDevice&) = delete;
  SceneOnDevice& operator=(const SceneOnDevice&) = delete;

  const Scene& scene() const { return scene_; }
  Device& device() const { return device_; }
  MeshId mesh(int index) const { return meshes_[static_cast<std::size_t>(index)]; }
  TextureId image(int index) const;          // None for index -1
  TextureId external(const std::string& name) const;  // kCasterMaterials, kEnvironment, or None

 private:
  const Scene& scene_;
  Device& device_;
  std::vector<MeshId> meshes_;
  std::vector<TextureId> images_;
  std::map<std::string, TextureId> externals_;
};

// The textures a plan writes, made once and used frame after frame.
class FrameTargets {
 public:
  FrameTargets(const FramePlan& plan, Device& device);
  ~FrameTargets();
  FrameTargets(const FrameTargets&) = delete;
  FrameTargets& operator=(const FrameTargets&) = delete;
  TextureId operator[](int index) const { return textures_[static_cast<std::size_t>(index)]; }

 private:
  Device& device_;
  std::vector<TextureId> textures_;
};

// What a frame is drawn from besides the scene.
struct FrameInputs {
  const Settings* settings = nullptr;
  const Effects* effects = nullptr;
  const std::vector<LightFrames>* frames = nullptr;  // by Scene::lights
  Frame view;
  float exposure = 1.0f;
};

struct PassReport {
  std::string label;
  PassResult result;
};

// Called after each pass; returning false stops the frame (Error Interrupted is thrown by run_plan).
using AfterPass = std::function<bool(const PlannedPass&, const PassResult&, std::size_t done,
                                     std::size_t total)>;

std::vector<PassReport> run_plan(const FramePlan& plan, const Registry& registry,
                                 const SceneOnDevice& scene, const FrameTargets& targets,
                                 const FrameInputs& inputs, const AfterPass& after = {});

// The frames of every light, fitted to the casters and to where their light lands. Finds the latter
// by running the passes that lead to `landing` coarsely on `device`, which should be the software
// device whatever backend renders, so that both see the same frames.
std::vector<LightFrames> fit_light_frames(const SceneOnDevice& scene, const Effects& effects,
                                          const Settings& settings, const Registry& registry);

// The factor from nit to display white: `settings.exposure` EV above or below the automatic one,
// under which a white diffuse surface that faces the brightest light shows at 0.8 of display white.
float exposure_of(const Scene& scene, const Settings& settings, const Bounds& bounds);

}  // namespace caustics
