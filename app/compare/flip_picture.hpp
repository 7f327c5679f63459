// The picture of a FLIP map that `caustics compare --flip --diff PREFIX` writes.
#pragma once
#include "app/selection.hpp"
#include "pipeline/gpu/image.hpp"

namespace caustics::app {

// The map, black (0: the same) to white (1) by way of colours, grey where texels are not selected;
// below it the scale of colours with numbers. At least as wide as the scale. Rows from the bottom.
Image flip_picture(const Image& map, const Selection& selection);

}  // namespace caustics::app
