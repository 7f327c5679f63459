// A scene as the sub-commands want it: loaded and completed; at any moment of its animation.
#pragma once
#include <memory>

#include "pipeline/renderer/exposure.hpp"
#include "pipeline/scene/animated_scene.hpp"
#include "pipeline/scene/lamp_meshes.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::app {

struct FrameRequest;

// What a file leaves out (ground, light, camera, sky) and the automatic exposure are chosen once, from
// the scene at 0 s with its moving meshes as large as all that they touch in the course of the
// animation. So they do not depend on which moments are shown.
class LoadedScene {
 public:
  // Stands at request.seconds, or 0 s. Throws Error: BadInput, or WrongUsage for an unknown camera or
  // animation.
  explicit LoadedScene(const FrameRequest& request);
  LoadedScene(const LoadedScene&) = delete;
  LoadedScene& operator=(const LoadedScene&) = delete;

  const Scene& scene() const { return scene_; }
  Scene& scene() { return scene_; }  // for its waters to move
  const Camera& camera() const { return camera_; }
  const Exposure& exposure() const { return exposure_; }

  // AnimatedScene::files; none of them is an output of the request.
  const std::vector<std::filesystem::path>& files() const { return animation_.files(); }
  bool moves() const { return animation_.moves(); }
  double duration() const { return animation_.duration(); }
  // Completed::added.
  const std::vector<std::string>& added() const { return added_; }
  const std::vector<int>& moving_meshes() const { return moving_; }
  // Everything as it is at that moment, whatever moment came before.
  void move_to(double seconds);

 private:
  Lamps judge_what_shines() const;
  void light_up();
  void complete(const Pilot& pilot);
  void note_environment();
  void choose_camera();

  Settings settings_;
  AnimatedScene animation_;
  std::vector<int> moving_;
  std::vector<Bounds> swept_;  // by moving_; the next too
  std::vector<std::vector<glm::vec3>> outlines_;
  Scene scene_;
  // What completing the scene added, if anything; each moment starts without it.
  std::vector<Light> added_sources_;
  std::vector<Camera> added_cameras_;
  std::vector<Light> lamps_;  // meshes that light the scene: which, and by how many samples
  std::vector<std::string> added_, notes_;
  Exposure exposure_;
  Camera camera_;
};

std::unique_ptr<LoadedScene> load_scene(const FrameRequest& request);

}  // namespace caustics::app
