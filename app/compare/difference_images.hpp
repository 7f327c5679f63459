// `caustics compare --diff PREFIX`: two pictures of where two images differ.
#pragma once
#include <filesystem>
#include <string>

#include "app/compare/image_difference.hpp"

namespace caustics::app {

// Where the pictures go.
struct DifferencePaths {
  explicit DifferencePaths(const std::string& prefix)
      : signed_exr(prefix + "_signed.exr"), color_png(prefix + "_color.png") {}
  std::filesystem::path signed_exr;  // A - B of each channel
  std::filesystem::path color_png;   // the largest |A - B| of a texel's channels as a colour
};

// Empty where the channels that could be compared make one image.
std::string why_not_drawable(const PlanesDifference& difference);

// Writes both, of the channels that could be compared (black and 0 where texels are not selected),
// and returns the scale of the colours in words. Only where they are drawable; throws Error
// (CannotWrite).
std::string write_difference_images(const DifferencePaths& paths, const PlanesDifference& difference,
                                    const Selection& selection = {});

}  // namespace caustics::app
