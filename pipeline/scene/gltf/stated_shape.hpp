// What `extras` of a mesh and of its node say of the shape that it stands for (docs/reference.md has the
// keys).
#pragma once
#include "pipeline/scene/gltf/nodes.hpp"

namespace caustics::gltf {

// Fills scene.stated_shapes by `extras.exact_shape` of nodes, or else of their meshes. `placements` are the
// nodes that the meshes' `object` counts. Fails on what is no shape; whether the mesh lies on it is asked by
// who uses it.
void read_stated_shapes(const Cursor& root, const std::vector<Placement>& placements, Scene& scene);

}  // namespace caustics::gltf
