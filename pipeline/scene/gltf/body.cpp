#include "pipeline/scene/gltf/body.hpp"

#include <utility>

namespace caustics::gltf {

namespace {

using exact::Affine;

void add_scaled(glm::dvec3& sum, const Affine& part, double weight, Affine& blend) {
  blend.x += part.x * weight;
  blend.y += part.y * weight;
  blend.z += part.z * weight;
  sum += part.translation * weight;
}

class Poser {
 public:
  Poser(const Context& context, const Body& body, Shape shape, const Pose& pose)
      : context_(context), body_(body), pose_(pose), shape_(std::move(shape)) {}

  Shape run() {
    for (std::size_t t = 0; t < body_.targets.size(); ++t)
      if (pose_.morph[t] != 0.0) morph(body_.targets[t], pose_.morph[t]);
    const bool skinned = body_.influences > 0 && !pose_.joints.empty();
    const bool mirrored = pose_.to_world.determinant() < 0;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < shape_.positions.size(); ++i) {
      if (skinned) {
        const Affine place = blended(i);
        const bool turns = place.determinant() < 0;
        turned += turns;
        put(i, place, turns);
      } else {
        put(i, pose_.to_world, mirrored);
      }
    }
    if (skinned ? 2 * turned > shape_.positions.size() : mirrored)
      for (auto& triangle : shape_.triangles) std::swap(triangle[1], triangle[2]);
    return std::move(shape_);
  }

 private:
  void morph(const MorphTarget& target, double weight) {
    for (std::size_t i = 0; i < target.positions.size(); ++i)
      shape_.positions[i] += glm::dvec3(target.positions[i]) * weight;
    if (!shape_.normals.empty())
      for (std::size_t i = 0; i < target.normals.size(); ++i)
        shape_.normals[i] += glm::dvec3(target.normals[i]) * weight;
    if (!shape_.tangents.empty())
      for (std::size_t i = 0; i < target.tangents.size(); ++i)
        shape_.tangents[i] += glm::dvec4(glm::dvec3(target.tangents[i]) * weight, 0.0);
  }

  Affine blended(std::size_t vertex) const {
    Affine blend{glm::dvec3(0), glm::dvec3(0), glm::dvec3(0), glm::dvec3(0)};
    for (std::size_t k = 0; k < body_.influences; ++k) {
      const std::size_t at = vertex * body_.influences + k;
      const auto weight = static_cast<double>(body_.weights[at]);
      if (weight == 0.0) continue;
      add_scaled(blend.translation, pose_.joints[body_.joints[at]], weight, blend);
    }
    return blend;
  }

  void put(std::size_t i, const Affine& to_world, bool mirrored) {
    const glm::dvec3 world = to_world.point(shape_.positions[i]);
    const double most = context_.options().max_coordinate;
    const glm::dvec3 size = glm::abs(world);
    if (!(size.x <= most && size.y <= most && size.z <= most)) {
      context_.fail(body_.position_path,
                    "position " + std::to_string(i) + " lies more than 1e12 m from the origin",
                    "check the scene's scale");
    }
    shape_.positions[i] = world;
    if (!shape_.normals.empty()) shape_.normals[i] = to_world.normal(shape_.normals[i]);
    if (shape_.tangents.empty()) return;
    glm::dvec4& t = shape_.tangents[i];
    const glm::dvec3 tangent = to_world.direction({t.x, t.y, t.z});
    t = {tangent.x, tangent.y, tangent.z, (t.w < 0) != mirrored ? -1.0 : 1.0};
  }

  const Context& context_;
  const Body& body_;
  const Pose& pose_;
  Shape shape_;
};

}  // namespace

Shape posed(const Context& context, const Body& body, const Pose& pose) {
  return Poser(context, body, body.shape, pose).run();
}

Shape posed(const Context& context, Body&& body, const Pose& pose) {
  return Poser(context, body, std::move(body.shape), pose).run();
}

}  // namespace caustics::gltf
