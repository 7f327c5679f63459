// The bounding-volume hierarchy over a scene's triangles, as textures that shaders walk
// (passes/shared/hierarchy.glsl). Tables are rows of kTableWidth texels, read by one index.
#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/gpu/image.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics {

// table_fetch() has it as 12 bits (pipeline/shader/prelude.glsl).
inline constexpr int kTableWidth = 4096;
// Numbers of triangles pass through single precision.
inline constexpr std::size_t kMostTriangles = std::size_t{1} << 24;

// The meshes whose triangles are in the hierarchy, casters first: a triangle's number is its place when all
// of them are put one after the other.
struct HierarchyMeshes {
  std::vector<int> casters, receivers;  // indices into Scene::meshes
  std::vector<int> bodies;              // by Scene::meshes: of a caster the row of its body's material
};

struct HierarchyTables {
  // An inner node takes four texels: of either child the lower corner of its box and `first`, the upper
  // corner and `count`. Where the count is 0 the child is the inner node `first`, else a leaf of `count`
  // triangles from the place `first` on.
  Image nodes;
  // A triangle takes three texels, leaf after leaf: its corners; and its number, the row of its material in
  // caster_materials, and the row of its body's plus 1.
  Image triangles;
  // Likewise, by number: its corners' normals; and its place in `triangles`.
  Image normals;
};

// The number of a mesh's first triangle, by Scene::meshes; -1 for those that are not in the hierarchy.
std::vector<std::int64_t> first_triangles(const Scene& scene, const HierarchyMeshes& meshes);
// Of the first receiver: as many as casters have.
std::int64_t caster_triangles(const Scene& scene, const HierarchyMeshes& meshes);

// `rows`: by Scene::meshes, of caster_materials. `touch`: metres that every box is larger on each side.
// `threads`: as TriangleTree has it. Throws Error (BadInput) for more than kMostTriangles.
HierarchyTables hierarchy_tables(const Scene& scene, const HierarchyMeshes& meshes,
                                 const std::vector<int>& rows, float touch, int threads = 0);

}  // namespace caustics
