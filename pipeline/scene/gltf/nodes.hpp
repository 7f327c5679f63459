// Walks the node tree of the scene to be shown: what stands where in the world.
// Source: glTF 2.0 section 3.5; EXT_mesh_gpu_instancing; KHR_node_visibility.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/gltf/model.hpp"

namespace caustics::gltf {

// A node's transform as the file says it: parts that an animation may change, or a matrix.
struct NodeTransform {
  glm::dvec3 translation{0}, scale{1};
  glm::dvec4 rotation{0, 0, 0, 1};
  std::optional<exact::Affine> matrix;
  exact::Affine local() const;
};

// A node of the scene that is shown.
struct TreeNode {
  int node = 0;
  int parent = -1;  // its place in Placements::tree, before the node's own; -1: a root
  NodeTransform rest;
};

// Something that a node places: a mesh, a camera or a light, by its index.
struct Placement {
  int node = 0;
  int index = 0;
  exact::Affine to_world;
  std::string name;       // the node's, may be empty
  std::size_t place = 0;  // the node's in Placements::tree
  exact::Affine inner;    // an instance within its node: to_world = the node's * inner
  int skin = -1;          // of a mesh
};

struct Placements {
  std::vector<TreeNode> tree;     // parents first
  std::vector<int> place_of;      // by node: its place in `tree`; -1: not in the scene
  std::vector<Placement> meshes;  // one for each instance
  std::vector<Placement> cameras;
  std::vector<Placement> lights;  // index into KHR_lights_punctual's list
};

// Fails on cycles, nodes with two parents, trees too deep or too large, and transforms that are not
// finite. Takes the default scene, else the first, else all nodes without a parent.
Placements place_nodes(Context& context, const Document& document, const Model& model);

}  // namespace caustics::gltf
