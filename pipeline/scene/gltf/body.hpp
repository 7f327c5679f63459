// A primitive as its file has it, before it is put in its place: its own coordinates, what it can be
// morphed to, and the joints that pull at it.
// Source: glTF 2.0 sections 3.7.2.2 (morph targets) and 3.7.3 (skins).
#pragma once
#include <span>

#include "pipeline/scene/gltf/context.hpp"
#include "pipeline/scene/gltf/shape.hpp"

namespace caustics::gltf {

// Differences to the base shape, by vertex; empty: none.
struct MorphTarget {
  std::vector<glm::vec3> positions, normals, tangents;
};

struct Body {
  Shape shape;                // in the mesh's own coordinates; triangles as the file winds them
  std::string position_path;  // JSON path of the positions, for messages
  std::vector<MorphTarget> targets;
  // By vertex `influences` joints (numbers of the skin's) and weights that add up to 1; 0: no skin.
  std::size_t influences = 0;
  std::vector<std::uint32_t> joints;
  std::vector<float> weights;
};

// Where and how a body stands at one moment.
struct Pose {
  exact::Affine to_world;
  std::span<const double> morph;            // weights of the morph targets; as many as there are
  std::span<const exact::Affine> joints{};  // a skin's matrices, which then count instead of to_world
};

// The body in the world: morphed, then skinned or placed. Triangles of mirrored places are turned
// round, so that outside stays outside. Fails when a vertex comes beyond max_coordinate.
Shape posed(const Context& context, const Body& body, const Pose& pose);
// Of a body that is not needed any more: its shape is taken, not copied.
Shape posed(const Context& context, Body&& body, const Pose& pose);

}  // namespace caustics::gltf
