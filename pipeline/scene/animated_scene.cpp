#include "pipeline/scene/animated_scene.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/gpu/error.hpp"

namespace caustics {

namespace {

void renew_bounds(Mesh& mesh) {
  if (mesh.vertices.empty()) return;
  mesh.lower = mesh.upper = mesh.vertices.front().position;
  for (const Vertex& vertex : mesh.vertices) {
    mesh.lower = glm::min(mesh.lower, vertex.position);
    mesh.upper = glm::max(mesh.upper, vertex.position);
  }
}

// The moment of the first round that looks the same. fmod is exact.
double within(double seconds, double duration) {
  return duration > 0.0 ? std::fmod(std::max(seconds, 0.0), duration) : 0.0;
}

}  // namespace

void AnimatedScene::add(std::shared_ptr<MeshAnimator> animator) {
  if (!motion_ && animators_.empty()) {
    lights_ = start_.lights;
    cameras_ = start_.cameras;
  }
  const std::vector<int> moving = moving_meshes();
  for (const int mesh : animator->meshes()) {
    if (mesh < 0 || static_cast<std::size_t>(mesh) >= start_.meshes.size())
      throw Error(ExitCode::InternalError,
                  "an animator moves mesh " + std::to_string(mesh) + ", which the scene lacks");
    if (std::find(moving.begin(), moving.end(), mesh) != moving.end()) continue;
    resting_.push_back({mesh, start_.meshes[static_cast<std::size_t>(mesh)].vertices});
  }
  animators_.push_back(std::move(animator));
}

std::vector<int> AnimatedScene::moving_meshes() const {
  std::vector<int> meshes;
  if (motion_) meshes = motion_->meshes();
  for (const Resting& mesh : resting_) meshes.push_back(mesh.mesh);
  std::sort(meshes.begin(), meshes.end());
  return meshes;
}

std::optional<std::size_t> AnimatedScene::place_in_motion(int mesh) const {
  if (!motion_) return {};
  const auto& moving = motion_->meshes();
  const auto found = std::lower_bound(moving.begin(), moving.end(), mesh);
  if (found == moving.end() || *found != mesh) return {};
  return static_cast<std::size_t>(found - moving.begin());
}

Bounds AnimatedScene::swept_bounds(int mesh) const {
  const auto place = place_in_motion(mesh);
  return place ? motion_->swept()[*place] : bounds_of(start_.meshes[static_cast<std::size_t>(mesh)]);
}

std::vector<glm::vec3> AnimatedScene::outline(int mesh) const {
  std::vector<glm::vec3> points;
  if (const auto place = place_in_motion(mesh))
    for (const glm::dvec3& point : motion_->outlines()[*place]) points.emplace_back(point);
  return points;
}

Scene AnimatedScene::at(double seconds) const {
  Scene scene = start_;
  move_to(seconds, scene);
  return scene;
}

void AnimatedScene::move_to(double seconds, Scene& scene) const {
  if (!moves()) return;
  if (motion_) {
    motion_->place(within(seconds, motion_->duration()), scene);
  } else {
    scene.lights = lights_;
    scene.cameras = cameras_;
  }
  for (const Resting& mesh : resting_)
    scene.meshes[static_cast<std::size_t>(mesh.mesh)].vertices = mesh.vertices;
  for (const auto& animator : animators_) {
    animator->move(seconds, scene);
    for (const int mesh : animator->meshes()) renew_bounds(scene.meshes[static_cast<std::size_t>(mesh)]);
  }
}

}  // namespace caustics
