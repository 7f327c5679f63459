// Where in a pixel the camera's samples lie, and how the camera looks to put them there: its window is
// shifted, so that what the pixels' middles see is what lies beside them.
#pragma once
#include <span>

#include "pipeline/scene/view.hpp"

namespace caustics {

// From the pixel's middle, sixteenths of a pixel.
struct SubPixel {
  int x = 0, y = 0;
};

// The standard sample locations of Direct3D 11 and of the Vulkan specification's table of that name: of 4
// samples the rotated grid. In all rows and columns that samples lie in lies one. Of 1, 4, 8 or 16.
std::span<const SubPixel> sub_pixels(int samples);

// For targets of this size.
View shifted(const View& view, const SubPixel& by, int width, int height);
// All that any sample may see.
View around_samples(const View& view, int samples, int width, int height);

}  // namespace caustics
