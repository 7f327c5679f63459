// Images of any kind that OpenImageIO reads, as named channels of floats.
#pragma once
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/gpu/difference.hpp"

namespace caustics::app {

// One channel of a file. Row 0 is the top.
struct Plane {
  std::string name;
  ChannelView view;
  int left = 0, top = 0;  // of the data window; 0, 0 but for some EXR files
  bool integers = false;  // stored as such: display values (sRGB), where they are colours
};

struct ImagePlanes {
  std::deque<std::vector<float>> storage;  // what the views look into
  std::vector<Plane> planes;               // in the file's order, each name once

  ImagePlanes() = default;
  ImagePlanes(ImagePlanes&&) = default;
  ImagePlanes& operator=(ImagePlanes&&) = default;
};

// Every channel of every part, values as they are stored: no colour is transformed, alpha not
// multiplied; integers become 0..1. Channels of a file of several parts are named PART.CHANNEL,
// unless their names begin so already. Throws Error (BadInput): no plain file, no image, damaged,
// deep or volumetric, or a channel of 32-bit integers, which floats do not hold.
ImagePlanes read_planes(const std::filesystem::path& path);

}  // namespace caustics::app
