#include "pipeline/scene/gltf/motion.hpp"

#include "pipeline/scene/gltf/lights.hpp"
#include "pipeline/scene/gltf/surface.hpp"

namespace caustics::gltf {

namespace {

// Moments by which what a body touches is found out: enough for views, not for exact bounds.
constexpr int kSweeps = 24;

}  // namespace

Stance::Stance(const Placements& placements, const std::vector<std::vector<double>>& rest_weights)
    : placements_(placements), weights_(rest_weights) {
  for (const TreeNode& node : placements.tree) transforms_.push_back(node.rest);
}

void Stance::move(const Animation& animation, double seconds) {
  for (const Channel& channel : animation.channels) {
    const int place = placements_.place_of[channel.node];
    if (place < 0) continue;
    const auto p = static_cast<std::size_t>(place);
    const std::vector<double> v = channel.keys.at(seconds);
    switch (channel.property) {
      case Property::Translation:
        transforms_[p].translation = {v[0], v[1], v[2]};
        break;
      case Property::Rotation:
        transforms_[p].rotation = {v[0], v[1], v[2], v[3]};
        break;
      case Property::Scale:
        transforms_[p].scale = {v[0], v[1], v[2]};
        break;
      case Property::Weights:
        weights_[p] = v;
        break;
    }
  }
}

void Stance::finish(const Context& context) {
  to_world_.clear();
  for (std::size_t i = 0; i < transforms_.size(); ++i) {
    const TreeNode& node = placements_.tree[i];
    const exact::Affine parent =
        node.parent < 0 ? exact::Affine{} : to_world_[static_cast<std::size_t>(node.parent)];
    to_world_.push_back(parent * transforms_[i].local());
    if (!to_world_.back().finite()) {
      context.fail("nodes[" + std::to_string(node.node) + "]", "its transform is not finite",
                   "correct its scale and its animation");
    }
  }
}

Pose pose_of(const Placement& placement, const std::vector<Skin>& skins, const Stance& stance,
             const Body& body, std::vector<exact::Affine>& joints) {
  Pose pose;
  pose.to_world = stance.to_world(placement.place) * placement.inner;
  if (!body.targets.empty()) pose.morph = stance.weights(placement.place);
  if (placement.skin >= 0 && body.influences > 0) {
    joints = skins[static_cast<std::size_t>(placement.skin)].matrices(stance.to_world());
    pose.joints = joints;
  }
  return pose;
}

GltfMotion::GltfMotion(MotionParts parts) : parts_(std::move(parts)) { sweep(); }

void GltfMotion::set_meshes(const std::vector<int>& meshes, const glm::dvec3& origin) {
  meshes_ = meshes;
  origin_ = origin;
  for (std::size_t i = 0; i < meshes.size(); ++i) parts_.bodies[i].mesh = meshes[i];
  for (Bounds& bounds : swept_) {
    bounds.lower -= origin;
    bounds.upper -= origin;
  }
}

void GltfMotion::start(Document document, Scene& scene) {
  parts_.document = std::move(document);
  place(0.0, scene);
}

Stance GltfMotion::stance(const Context& context, double seconds) const {
  Stance stance(parts_.placements, parts_.rest_weights);
  stance.move(parts_.animation, seconds);
  stance.finish(context);
  return stance;
}

void GltfMotion::sweep() {
  const Context context(parts_.path, parts_.options);
  swept_.resize(parts_.bodies.size());
  for (int k = 0; k <= kSweeps; ++k) {
    const Stance now = stance(context, duration() * k / kSweeps);
    for (std::size_t i = 0; i < parts_.bodies.size(); ++i) {
      const MovingBody& moving = parts_.bodies[i];
      std::vector<exact::Affine> joints;
      const Pose pose =
          pose_of(parts_.placements.meshes[moving.placement], parts_.skins, now, moving.body, joints);
      const Shape shape = posed(context, moving.body, pose);
      for (const auto& triangle : shape.triangles)
        for (const std::uint32_t corner : triangle) swept_[i].add(shape.positions[corner]);
    }
  }
}

void GltfMotion::place(double seconds, Scene& scene) const {
  // What there is to note was noted when the file was read.
  Context context(parts_.path, parts_.options);
  const Stance now = stance(context, seconds);
  for (const MovingBody& moving : parts_.bodies) {
    std::vector<exact::Affine> joints;
    const Pose pose =
        pose_of(parts_.placements.meshes[moving.placement], parts_.skins, now, moving.body, joints);
    Shape shape = posed(context, moving.body, pose);
    finish_normals(context, shape);
    if (moving.tangents) {
      finish_tangents(context, shape, moving.uv_transform);
    } else {
      shape.tangents.clear();
    }
    scene.meshes[static_cast<std::size_t>(moving.mesh)] = finish_mesh(shape, origin_);
  }
  const auto moved = [&](std::vector<Placement> list) {
    for (Placement& placement : list) placement.to_world = now.to_world(placement.place);
    return list;
  };
  scene.lights = read_lights(context, parts_.document, moved(parts_.placements.lights), origin_);
  scene.cameras = read_cameras(context, parts_.document, moved(parts_.placements.cameras), origin_);
}

}  // namespace caustics::gltf
