// What passes read that follow light from surface to surface, and what they write of it.
#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

inline constexpr Read kReadHierarchyNodes{.name = kHierarchyNodes,
                                          .meaning = "boxes around the casters' and receivers' triangles"};
inline constexpr Read kReadHierarchyTriangles{.name = kHierarchyTriangles,
                                              .meaning = "their corners, numbers, materials and bodies"};
inline constexpr Read kReadHierarchyNormals{.name = kHierarchyNormals, .meaning = "their normals, by number"};

// A ray texture (passes/shared/ray_state.glsl) as the surface before has left it.
inline Read path_read(std::string_view name, std::string_view texture) {
  return {.name = name,
          .meaning = "light under way",
          .texture = texture,
          .surface = OfSurface::Before,
          .discards_where_zero = texture == "ray_start"};
}
// All of them, in the order of the shaders that read them all.
std::vector<Read> path_reads();
// All of them, and what the ledger is told.
std::vector<Write> path_writes();

}  // namespace caustics
