// Walks the node tree of the scene to be shown: what stands where in the world.
// Source: glTF 2.0 section 3.5; EXT_mesh_gpu_instancing; KHR_node_visibility.
#pragma once
#include <string>
#include <vector>

#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/gltf/model.hpp"

namespace caustics::gltf {

// Something that a node places: a mesh, a camera or a light, by its index.
struct Placement {
  int node = 0;
  int index = 0;
  exact::Affine to_world;
  std::string name;  // the node's, may be empty
};

struct Placements {
  std::vector<Placement> meshes;  // one for each instance
  std::vector<Placement> cameras;
  std::vector<Placement> lights;  // index into KHR_lights_punctual's list
};

// Fails on cycles, nodes with two parents, trees too deep or too large, and transforms that are not
// finite. Takes the default scene, else the first, else all nodes without a parent.
Placements place_nodes(Context& context, const Document& document, const tinygltf::Model& model);

}  // namespace caustics::gltf
