// What `extras` of a mesh and of its node say of water that moves (docs/water.md has the keys).
#pragma once
#include "pipeline/scene/gltf/nodes.hpp"

namespace caustics::gltf {

// Makes water (scene.waters) of the scene's meshes whose node, or else whose mesh, has `extras.water`.
// `placements` are the nodes that the meshes' `object` counts. Fails on values out of range and on meshes
// that are no open horizontal sheet.
void read_waters(const Cursor& root, const std::vector<Placement>& placements, Scene& scene);

}  // namespace caustics::gltf
