// Which part of a light's caustic maps each pixel of the picture reads.
#pragma once
#include <cstdint>
#include <vector>

#include "app/frame.hpp"

namespace caustics::app {

struct PixelFootprints {
  static constexpr std::uint8_t kNone = 255;
  int width = 0, height = 0;
  // By pixel, rows from the bottom: 0 the whole map, 1 the cascade, 2 the map of the farthest receivers;
  // kNone where the pixel has no light from any.
  std::vector<std::uint8_t> map;
  // Likewise x0, y0, x1, y1 in texels of that map: texel i reaches from i to i + 1.
  std::vector<float> rectangle;
};

// The maps' names among what light_shading reads, by the numbers above.
inline constexpr const char* kFootprintMaps[] = {"caustic_map", "cascade_map", "far_caustic_map"};

// Of a pass light_shading that has just run: each pixel's samples, as its text hands them out.
PixelFootprints pixel_footprints(const RenderedFrame& frame, const PlannedPass& light_shading);

}  // namespace caustics::app
