#include "pipeline/scene/gltf/motion.hpp"

#include <array>
#include <limits>

#include "pipeline/scene/gltf/lights.hpp"
#include "pipeline/scene/gltf/surface.hpp"

namespace caustics::gltf {

namespace {

// Moments by which what a body touches is found out: enough for views, not for exact bounds.
constexpr int kSweeps = 24;

// The points farthest to both sides along each of these: a cube's edges, its faces' diagonals and its own.
constexpr std::array<std::array<int, 3>, 13> kAxes = {{{1, 0, 0},
                                                       {0, 1, 0},
                                                       {0, 0, 1},
                                                       {1, 1, 0},
                                                       {1, -1, 0},
                                                       {1, 0, 1},
                                                       {1, 0, -1},
                                                       {0, 1, 1},
                                                       {0, 1, -1},
                                                       {1, 1, 1},
                                                       {1, 1, -1},
                                                       {1, -1, 1},
                                                       {-1, 1, 1}}};

class Outline {
 public:
  void add(const glm::dvec3& p) {
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const double along = kAxes[i][0] * p.x + kAxes[i][1] * p.y + kAxes[i][2] * p.z;
      Side &low = sides_[2 * i], &high = sides_[2 * i + 1];
      if (-along > low.far) low = {-along, p};
      if (along > high.far) high = {along, p};
    }
  }

  std::vector<glm::dvec3> points() const {
    std::vector<glm::dvec3> points;
    for (const Side& side : sides_)
      if (exact::finite(side.point)) points.push_back(side.point);
    return points;
  }

 private:
  struct Side {
    double far = -std::numeric_limits<double>::infinity();
    glm::dvec3 point{far};
  };
  std::array<Side, 2 * kAxes.size()> sides_;
};

std::vector<std::uint32_t> used_vertices(const Shape& shape) {
  std::vector<bool> used(shape.positions.size(), false);
  std::vector<std::uint32_t> list;
  for (const auto& triangle : shape.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (!used[corner]) list.push_back(corner);
      used[corner] = true;
    }
  }
  return list;
}

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
  for (auto& outline : outlines_)
    for (glm::dvec3& point : outline) point -= origin;
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
  std::vector<Outline> outlines(parts_.bodies.size());
  std::vector<std::vector<std::uint32_t>> used;
  for (const MovingBody& moving : parts_.bodies) used.push_back(used_vertices(moving.body.shape));
  for (int k = 0; k <= kSweeps; ++k) {
    const Stance now = stance(context, duration() * k / kSweeps);
    for (std::size_t i = 0; i < parts_.bodies.size(); ++i) {
      const MovingBody& moving = parts_.bodies[i];
      std::vector<exact::Affine> joints;
      const Pose pose =
          pose_of(parts_.placements.meshes[moving.placement], parts_.skins, now, moving.body, joints);
      const Shape shape = posed(context, moving.body, pose);
      for (const std::uint32_t vertex : used[i]) {
        swept_[i].add(shape.positions[vertex]);
        outlines[i].add(shape.positions[vertex]);
      }
    }
  }
  for (const Outline& outline : outlines) outlines_.push_back(outline.points());
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
