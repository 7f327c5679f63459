// What passes read that follow light or sight from surface to surface.
#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

inline constexpr Read kReadHierarchyNodes{.name = kHierarchyNodes,
                                          .meaning = "boxes around the casters' and receivers' triangles"};
inline constexpr Read kReadHierarchyTriangles{.name = kHierarchyTriangles,
                                              .meaning = "their corners, numbers, materials and bodies"};
inline constexpr Read kReadHierarchyNormals{.name = kHierarchyNormals, .meaning = "their normals, by number"};

}  // namespace caustics
