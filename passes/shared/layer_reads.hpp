// What passes read of the blended surfaces that lie before all else.
#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

inline constexpr Read kReadLayers{.name = "layers",
                                  .meaning = "blended surfaces: their radiance, and how much passes them",
                                  .texture = "scene_color",
                                  .optional = true,
                                  .layer = OfLayer::Before};
inline constexpr Read kReadFirstLayer{.name = "first_layer",
                                      .meaning = "whether they lie before glass",
                                      .texture = "view_position",
                                      .layers_discard_where_zero = true,
                                      .optional = true,
                                      .layer = OfLayer::First};

}  // namespace caustics
