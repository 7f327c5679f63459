// The stated error of a picture's caustics, pixel by pixel.
#pragma once
#include <vector>

#include "app/flux.hpp"

namespace caustics::app {

// Lux, r, g, b; 0 where a caster is seen. The model's error as rays have shown it, even over each block of
// pixels; the other parts in proportion to the caustic.
Image stated_error(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers);

}  // namespace caustics::app
