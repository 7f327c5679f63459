// Images by the means of blocks of texels: what is left of a difference that is not looked at texel by texel.
#pragma once
#include <string>

#include "app/output/image_planes.hpp"

namespace caustics::app {

// Puts the means over squares of `side` x `side` texels in the place of the texels, counted from the top
// left; those at the right and lower edges are smaller where the size is no multiple.
void take_block_means(ImagePlanes& image, int side);

}  // namespace caustics::app
