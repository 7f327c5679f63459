// What passes read that follow light or sight from surface to surface.
#pragma once
#include <algorithm>

#include "pipeline/effects/textured_casters.hpp"
#include "pipeline/plan/pass.hpp"

namespace caustics {

inline constexpr Read kReadHierarchyNodes{.name = kHierarchyNodes,
                                          .meaning = "boxes around the casters' and receivers' triangles"};
inline constexpr Read kReadHierarchyTriangles{.name = kHierarchyTriangles,
                                              .meaning = "their corners, numbers, materials and bodies"};
inline constexpr Read kReadHierarchyNormals{.name = kHierarchyNormals,
                                            .meaning = "their normals, by number; texture coordinates"};

inline constexpr Read kReadCasterTexels{
    .name = kCasterTexels, .meaning = "the pictures on surfaces, side by side", .optional = true};

inline constexpr Choice kHasTextures{
    "has_textures", [](const PassContext& c) { return light_meets_textures(*c.effects) ? 1 : 0; }};

inline constexpr Choice kHasCutOuts{"has_cut_outs", chosen_by<&Effects::cut_out_receivers>};

// Walls of rough glass, and panes.
inline constexpr Choice kHasWalls{"has_walls", [](const PassContext& c) {
                                    const auto& all = c.effects->surfaces;
                                    return std::any_of(all.begin(), all.end(), is_wall) ? 1 : 0;
                                  }};

}  // namespace caustics
