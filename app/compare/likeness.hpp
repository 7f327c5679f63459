// What a difference of two images looks like, where one simple cause explains nearly all of it: rows upside
// down, channels swapped, half floats, a constant factor. Such are the first mistakes of a renderer that is
// being brought up.
#pragma once
#include <string>
#include <vector>

#include "app/compare/image_difference.hpp"

namespace caustics::app {

// A phrase for each cause that takes away 99 % of sum |A - B| over the channels that differ; none where no
// cause does, where the images are alike or of different shapes, and where a NaN or an infinity stands in the
// way. Of the selected texels alone, but for rows.
std::vector<std::string> likenesses(const PlanesDifference& difference, const Selection& selection = {});

}  // namespace caustics::app
