// Skins: joints that pull at vertices.
// Source: glTF 2.0 section 3.7.3. The transform of the node that has the skinned mesh is ignored.
#pragma once
#include "pipeline/scene/gltf/body.hpp"
#include "pipeline/scene/gltf/nodes.hpp"

namespace caustics::gltf {

struct Skin {
  std::vector<std::size_t> joints;           // places in Placements::tree
  std::vector<exact::Affine> inverse_binds;  // one for each joint
  // The matrix of each joint, when the tree's nodes stand so.
  std::vector<exact::Affine> matrices(std::span<const exact::Affine> to_world) const;
};

// A skin of the file. Fails where a joint stands twice or lies outside of the scene that is shown, or
// there are too few inverse bind matrices, or one is not finite.
Skin read_skin(const Context& context, const Document& document, const Model& model, std::size_t skin,
               const Placements& placements);

// Reads JOINTS_n and WEIGHTS_n of the vertices `used` into the body. Nothing where the primitive has
// neither; fails where they do not go together, a joint is beyond the skin's, or a weight negative.
// The primitive stands at `cursor`, with its attributes' own accessors where the file has them packed.
void read_influences(Context& context, const Cursor& cursor, const Primitive& primitive, const Model& model,
                     std::size_t vertices, std::span<const std::uint32_t> used, std::size_t joints,
                     Body& body);

}  // namespace caustics::gltf
