// What one light gives to each pixel of the picture, and which texels of its caustic maps it comes from: the
// numbers that `probe --pixel` prints of one pixel, of all.
#pragma once
#include <cstdint>
#include <vector>

#include "app/frame.hpp"

namespace caustics::app {

// Rows from the bottom.
struct PixelTable {
  int width = 0, height = 0;
  std::vector<std::uint32_t> start{};  // by pixel: its first look-up; one more at the end
  std::vector<std::uint8_t> samples{};
  // By look-up, as MapFetch has them: the map's number; u, v, share, irradiance of flux.
  std::vector<std::uint8_t> map{};
  std::vector<float> fetches{};
  // By pixel, four channels each, lux; empty where the pass gives none.
  std::vector<float> direct{}, caustic{};
};

// Of a pass light_shading that has just run.
PixelTable pixel_table(const RenderedFrame& frame, const PlannedPass& light_shading);

}  // namespace caustics::app
