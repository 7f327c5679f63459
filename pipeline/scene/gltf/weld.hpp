// Finds vertices that lie in the same place.
#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/scene/gltf/shape.hpp"

namespace caustics::gltf {

// For every vertex of the group (shapes one after the other) a number that it shares with all
// vertices in its place. Places are the same within a millionth of the group's extent: the two
// sides of a seam often differ by rounding. Takes time n log n whatever the positions are.
std::vector<std::uint32_t> weld(const std::vector<Shape*>& group);

}  // namespace caustics::gltf
