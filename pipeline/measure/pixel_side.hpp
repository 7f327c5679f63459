// How large a picture's pixels are on a caustic map.
#pragma once
#include "pipeline/gpu/image_view.hpp"
#include "pipeline/scene/view.hpp"

namespace caustics {

// The side of a pixel in texels of a caustic map: the root of its area there, on the mean over the light in
// the map that the picture sees. `view_position`: scene space, w != 0 where there is a surface. 0 where the
// picture sees none of the light. `coarser`: looks at every so manieth pixel of a row and of a column.
double pixel_side(const ImageView& view_position, const ImageView& caustic_map, const View& caustic,
                  int coarser = 1);

}  // namespace caustics
