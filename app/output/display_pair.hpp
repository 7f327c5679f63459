// A layer of both images as a screen shows it, for FLIP.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/compare/image_difference.hpp"
#include "app/selection.hpp"
#include "pipeline/gpu/image.hpp"

namespace caustics::app {

struct DisplayPair {
  Image a, b;  // rgb: sRGB-encoded; rows from the bottom
  // What linear values were multiplied with before the tone map; none for display values.
  std::optional<double> exposure;
  std::string impossible;  // why there is none, else ""
};

// Of linear light: two images of one size with three channels or more, rows from the bottom. Both
// take one exposure, at which the 99th percentile (nearest rank) of B's luminances above 0 (0.2126
// R + 0.7152 G + 0.0722 B, selected texels) becomes 0.8, the end of the tone map's straight part;
// then the pass tone_map, on the software device. `mask`: in the order of the rows, 0 for texels left out;
// empty: all are selected.
DisplayPair display_pair(const Image& a, const Image& b, const std::vector<std::uint8_t>& mask = {});

// Of the channels R, G and B of one layer, which both images have in one size. Channels stored as
// integers are display values already, others linear light.
DisplayPair display_pair(const std::vector<const ChannelDifference*>& channels, const Selection& selection);

}  // namespace caustics::app
