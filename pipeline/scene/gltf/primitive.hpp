// Reads a glTF primitive into a Shape: attributes, indices, strips and fans, placed in the world.
// Source: glTF 2.0 section 3.7.2; KHR_mesh_quantization.
#pragma once
#include <optional>

#include "pipeline/scene/gltf/nodes.hpp"
#include "pipeline/scene/gltf/shape.hpp"

namespace caustics::gltf {

// Counts towards the limits on vertices and triangles of a whole scene.
struct GeometryBudget {
  std::uint64_t vertices = 0, triangles = 0;
};

// None for points, lines and what has no positions (with a note). `uv_set` is the TEXCOORD to read.
std::optional<Shape> read_primitive(Context& context, const Document& document,
                                    const tinygltf::Model& model, const Placement& placement,
                                    std::size_t primitive, int uv_set, GeometryBudget& budget);

}  // namespace caustics::gltf
