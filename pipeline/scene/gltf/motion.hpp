// What moves in a file with an animation: nodes and what they place, joints, morph weights.
#pragma once
#include "pipeline/scene/animated_scene.hpp"
#include "pipeline/scene/gltf/animation.hpp"
#include "pipeline/scene/gltf/body.hpp"
#include "pipeline/scene/gltf/skin.hpp"

namespace caustics::gltf {

// Where everything stands at one moment: the world transforms of Placements::tree, and the morph
// weights of its nodes.
class Stance {
 public:
  // Without an animation the stance at rest. Both must outlive it.
  Stance(const Placements& placements, const std::vector<std::vector<double>>& rest_weights);
  void move(const Animation& animation, double seconds);
  // Fails (BadInput) where a transform is not finite.
  void finish(const Context& context);

  const exact::Affine& to_world(std::size_t place) const { return to_world_[place]; }
  std::span<const exact::Affine> to_world() const { return to_world_; }
  const std::vector<double>& weights(std::size_t place) const { return weights_[place]; }

 private:
  const Placements& placements_;
  std::vector<NodeTransform> transforms_;
  std::vector<std::vector<double>> weights_;
  std::vector<exact::Affine> to_world_;
};

// A primitive that moves. Its triangles have been judged (surface and topology) at rest.
struct MovingBody {
  Body body;
  std::size_t placement = 0;  // in Placements::meshes
  bool tangents = false;      // for a normal texture
  glm::mat3 uv_transform{1.0f};
  int mesh = 0;  // index into Scene::meshes
};

// What a file's motion is made of. `document` needs nodes, cameras and extensions only.
struct MotionParts {
  std::filesystem::path path;
  LoadOptions options;
  Document document;
  Placements placements;
  std::vector<std::vector<double>> rest_weights;  // by Placements::tree
  std::vector<Skin> skins;
  Animation animation;
  std::vector<MovingBody> bodies;
};

// The pose of a placement's body. `joints` receives the skin's matrices where there is one.
Pose pose_of(const Placement& placement, const std::vector<Skin>& skins, const Stance& stance,
             const Body& body, std::vector<exact::Affine>& joints);

class GltfMotion final : public Motion {
 public:
  // Visits moments of the whole duration to learn what the bodies touch.
  explicit GltfMotion(MotionParts parts);
  // The bodies' meshes in their order, and the origin that scene space gets: known only when swept()
  // is, which is in world coordinates until then.
  void set_meshes(const std::vector<int>& meshes, const glm::dvec3& origin);
  // Takes the document, when all else has been read from it, and places the scene at 0 s.
  void start(Document document, Scene& scene);

  double duration() const override { return parts_.animation.duration; }
  const std::vector<int>& meshes() const override { return meshes_; }
  const std::vector<Bounds>& swept() const override { return swept_; }
  const std::vector<std::vector<glm::dvec3>>& outlines() const override { return outlines_; }
  void place(double seconds, Scene& scene) const override;

 private:
  Stance stance(const Context& context, double seconds) const;
  void sweep();

  MotionParts parts_;
  std::vector<int> meshes_;
  std::vector<Bounds> swept_;
  std::vector<std::vector<glm::dvec3>> outlines_;
  glm::dvec3 origin_{0};
};

}  // namespace caustics::gltf
