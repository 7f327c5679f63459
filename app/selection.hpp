// Which texels `caustics compare` looks at: --mask and --region.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace caustics {
struct ImagePlanes;
}

namespace caustics::app {

// Texels x..x+width-1, y..y+height-1, counted from the top left.
struct Region {
  int x = 0, y = 0, width = 0, height = 0;
};

// "X,Y,W,H"; throws Error (WrongUsage).
Region parse_region(const std::string& text);

// Made by select(); as it is here, it selects everything.
struct Selection {
  int width = 0, height = 0;       // of the images that it belongs to
  std::vector<std::uint8_t> mask;  // row by row from the top, 0: left out; empty: nothing is
  std::size_t texels = 0;          // selected ones

  bool all() const { return mask.empty(); }
  bool has(int x, int y) const {
    return all() || mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(x)] != 0;
  }
  // The mask for images whose rows run from the bottom.
  std::vector<std::uint8_t> from_bottom() const;
};

// Both of an image's texels and a mask's, where they are given: `mask` is a file, of which a texel
// counts where any channel but A (A too, where it is alone) is above 0; "" and a region without
// width leave them out. `image` says what they belong to and is compared; its channels all must
// have the mask's size. Throws Error: BadInput for another size and for nothing selected,
// WrongUsage for a region that reaches out of the image.
Selection select(const ImagePlanes& image, const std::filesystem::path& mask, const Region& region);

}  // namespace caustics::app
