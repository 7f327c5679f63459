// Reads a glTF primitive into a Body: attributes, indices, strips and fans, morph targets, joints.
// Source: glTF 2.0 section 3.7.2; KHR_mesh_quantization.
#pragma once
#include <optional>

#include "pipeline/scene/gltf/body.hpp"
#include "pipeline/scene/gltf/nodes.hpp"

namespace caustics::gltf {

// Counts towards the limits on vertices and triangles of a whole scene.
struct GeometryBudget {
  std::uint64_t vertices = 0, triangles = 0;
};

// None for points, lines and what has no positions (with a note). `uv_set` is the TEXCOORD to read,
// `joints` how many the skin of the placement has (0: no skin). Morph targets and sets of joints count as
// vertices.
std::optional<Body> read_primitive(Context& context, const Document& document, const Model& model,
                                   const Placement& placement, std::size_t primitive, int uv_set,
                                   std::size_t joints, GeometryBudget& budget);

}  // namespace caustics::gltf
