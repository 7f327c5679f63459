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
// As high as any device's textures are.
inline constexpr std::size_t kMostRows = 16384;
inline constexpr int kSheet = -2;

// The meshes whose triangles are in the hierarchy, casters first: a triangle's number is its place when all
// of them are put one after the other.
struct HierarchyMeshes {
  std::vector<int> casters, receivers;  // indices into Scene::meshes
  std::vector<int> bodies;              // by Scene::meshes: of a caster the row of its body's material;
                                        // kSheet: a blended surface, which light does not meet
  bool dressed = false;                 // casters have textures, for which texture coordinates are needed
  bool receivers_dressed = false;       // so have receivers
  std::vector<int> lamps{};             // whose points are wanted, indices into Scene::meshes
};

struct HierarchyTables {
  // An inner node takes four texels: of either child the lower corner of its box and `first`, the upper
  // corner and `count`. Where the count is 0 the child is the inner node `first`, else a leaf of `count`
  // triangles from the place `first` on.
  Image nodes;
  // A triangle takes three texels, leaf after leaf: its corners; and its number, the row of its material in
  // caster_materials, and the row of its body's plus 1, or -1 of a blended surface.
  Image triangles;
  // Likewise, by number: its corners' normals; and its place in `triangles`. Of what is dressed, casters or
  // all, from texel first_uv() on, kTexelsOfUv a triangle by number: texture coordinates of its first and
  // second corner; of the third; its corners' tangents, or colours where they have such. From texel
  // first_point() on, kPointsOfLamp of each lamp: their places and normals in turn.
  Image normals;
};
inline constexpr int kTexelsOfUv = 5;
inline constexpr int kPointsOfLamp = 4093;  // as passes/shared/way_draw.glsl draws them

// The number of a mesh's first triangle, by Scene::meshes; -1 for those that are not in the hierarchy.
std::vector<std::int64_t> first_triangles(const Scene& scene, const HierarchyMeshes& meshes);
// Of the first receiver: as many as casters have.
std::int64_t caster_triangles(const Scene& scene, const HierarchyMeshes& meshes);

// The first texel of texture coordinates in `normals`: behind all normals.
int first_uv(const Scene& scene, const HierarchyMeshes& meshes);
// The first texel of points of the lamp of this number among HierarchyMeshes::lamps.
int first_point(const Scene& scene, const HierarchyMeshes& meshes, std::size_t lamp);

// Made anew for each moment of a scene that moves, in 0.7 us a triangle on one thread. New boxes in the old
// tree would take a tenth of that; but rays then walk up to 15 % longer after a turn of 30 degrees, and 1.2
// to 3 times as long after a twist of 180, and a frame walks more than it builds: of 512 x 512 rays through
// 16 surfaces 0.2 s to 0.003 with 6000 triangles, 0.4 s to 0.06 with 86,000.
//
// `rows`: by Scene::meshes, of caster_materials. `touch`: metres that every box is larger on each side.
// `threads`: as TriangleTree has it. Throws Error (BadInput) for more than kMostTriangles, or a table of more
// than kMostRows rows.
HierarchyTables hierarchy_tables(const Scene& scene, const HierarchyMeshes& meshes,
                                 const std::vector<int>& rows, float touch, int threads = 0);

}  // namespace caustics
