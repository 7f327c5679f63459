// Renderings of one view beside each other and beside a truth, as the paper's figures 6, 7 and 11 show them.
#pragma once
#include <vector>

#include "pipeline/gpu/image.hpp"

namespace caustics::app {

// One picture of two rows. Above: `tested` in order and then `truth`, all at the exposure that shows the
// truth best. Below each: tested - truth, orange where there is more light than in the truth, blue where
// there is less (the scale of study's difference pictures); below the truth nothing. Linear light of one
// size, three channels or more, rows from the bottom; panels with a side above 320 pixels are averaged in
// boxes. Returns display values.
Image side_by_side(const std::vector<Image>& tested, const Image& truth);

}  // namespace caustics::app
