// A scene that changes with time: what does not move is there once, what moves is placed anew for
// each moment.
//
// Every moment stands for itself: the scene at some second has the same bits whichever moments were
// asked for before, in whatever order. So a frame rendered alone equals the same frame of a film.
//
// What may change from moment to moment: positions, normals, tangents and bounds of the meshes listed
// by moving_meshes(), all lights, all cameras. What may not: the number of meshes, lights and cameras,
// a mesh's number of vertices and indices, its material and its closedness (judged once, at rest),
// materials, images, environment, origin.
//
// Plugging in something else that moves, for example a water surface that is simulated: derive from
// MeshAnimator, and add() it. It runs after the file's own animation.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "pipeline/scene/scene.hpp"

namespace caustics {

// Moves the vertices of some meshes of a scene.
class MeshAnimator {
 public:
  virtual ~MeshAnimator() = default;
  // Indices into Scene::meshes: whose vertices it moves.
  virtual std::vector<int> meshes() const = 0;
  // Writes positions, normals (unit) and tangents of those meshes' vertices for the moment `seconds`
  // (>= 0, never wrapped round). The meshes come as the file has them at that moment, not as the last
  // call left them. Bounds are renewed by the caller. The result may depend on `seconds` and the
  // meshes alone: a simulation steps from its start, or keeps states of earlier moments that it has
  // reached by the same steps. It keeps out of everything else in the scene.
  virtual void move(double seconds, Scene& scene) = 0;
};

// What moves a scene as its file says (pipeline/scene/gltf/motion.hpp).
class Motion {
 public:
  virtual ~Motion() = default;
  // Seconds after which it begins again; 0 where it has one moment only.
  virtual double duration() const = 0;
  // Indices into Scene::meshes, ascending.
  virtual const std::vector<int>& meshes() const = 0;
  // By meshes(): everything that the mesh touches in the course of the motion, or nearly.
  virtual const std::vector<Bounds>& swept() const = 0;
  // By meshes(): points that it comes to, among them the farthest to many sides.
  virtual const std::vector<std::vector<glm::dvec3>>& outlines() const = 0;
  // Sets those meshes, and all lights and cameras. `seconds` lies within 0..duration.
  virtual void place(double seconds, Scene& scene) const = 0;
};

class AnimatedScene {
 public:
  // `start` is the scene at 0 s; without a motion nothing moves but what animators move.
  explicit AnimatedScene(Scene start, std::shared_ptr<const Motion> motion = nullptr,
                         std::vector<std::filesystem::path> files = {})
      : start_(std::move(start)), motion_(std::move(motion)), files_(std::move(files)) {}

  // Its meshes() must exist, else Error (InternalError). Animators run in the order they came.
  void add(std::shared_ptr<MeshAnimator> animator);

  bool moves() const { return motion_ || !animators_.empty(); }
  // Seconds of one round of the file's animation, 0 where it has none; later moments repeat it.
  double duration() const { return motion_ ? motion_->duration() : 0.0; }
  // Indices into Scene::meshes, ascending.
  std::vector<int> moving_meshes() const;
  // Scene::meshes[mesh] in the course of one round: what views and grounds are chosen by.
  Bounds swept_bounds(int mesh) const;
  // Likewise, as Mesh::outline; empty where an animator alone moves it.
  std::vector<glm::vec3> outline(int mesh) const;
  const Scene& start() const { return start_; }

  // The files that the scene's own file refers to, whether the scene uses them or not.
  const std::vector<std::filesystem::path>& files() const { return files_; }

  // The scene at a moment, finite and >= 0. Throws Error (BadInput) where the animation takes
  // something beyond all limits. Not at the same time from several threads where there are animators.
  Scene at(double seconds) const;

  // For programs that keep one scene and change it: take() hands over the scene at 0 s (start() and
  // at() have nothing to give from then on), and move_to() gives it the meshes, lights and cameras of
  // a moment. The caller may have added meshes after those of the file, and changed all else.
  Scene take() { return std::move(start_); }
  void move_to(double seconds, Scene& scene) const;

 private:
  // A mesh that animators alone move, as it was at the start.
  struct Resting {
    int mesh;
    std::vector<Vertex> vertices;
  };

  std::optional<std::size_t> place_in_motion(int mesh) const;  // in Motion::meshes

  Scene start_;
  std::shared_ptr<const Motion> motion_;
  std::vector<std::filesystem::path> files_;
  std::vector<std::shared_ptr<MeshAnimator>> animators_;
  std::vector<Resting> resting_;
  std::vector<Light> lights_;  // of the start, where no motion sets them
  std::vector<Camera> cameras_;
};

}  // namespace caustics
