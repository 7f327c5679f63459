// Morph targets: what a mesh can be morphed to, and how far it is at rest.
// Source: glTF 2.0 section 3.7.2.2; KHR_mesh_quantization.
#pragma once
#include <span>

#include "pipeline/scene/gltf/body.hpp"
#include "pipeline/scene/gltf/model.hpp"

namespace caustics::gltf {

// How many morph targets the primitives of a mesh have; fails where they differ.
std::size_t target_count(const Context& context, const Document& document, std::size_t mesh);

// The weights of a node's mesh at rest: the node's, else the mesh's, else zeros. Fails where they are
// not as many as the targets, or not numbers that single precision holds.
std::vector<double> rest_weights(const Context& context, const Document& document, std::size_t node,
                                 std::size_t mesh);

// The differences of a primitive's targets at the vertices `used` (numbers within the accessors).
// `primitive` is its cursor, `vertices` the number of its positions.
std::vector<MorphTarget> read_targets(Context& context, const Cursor& primitive, const Model& model,
                                      std::size_t vertices, std::span<const std::uint32_t> used);

}  // namespace caustics::gltf
