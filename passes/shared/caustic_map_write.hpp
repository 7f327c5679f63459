// A caustic map as an attachment: what cells and points alike add to.
#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// With three channels and the number of splats, or, where nothing tints the caustics, with one channel.
inline ColorWrite caustic_map_write(bool coloured, const char* name = kCausticMap) {
  if (coloured)
    return {.name = name,
            .format = Format::RGBA32F,
            .meaning = "rgb: flux in the texel, relative to the light's intensity (square metres, or "
                       "steradians); a: number of cells and splats, by weight",
            .blend = kAccumulate};
  return {.name = name,
          .format = Format::R32F,
          .meaning = "r: flux in the texel in every channel, relative to the light's intensity (square "
                     "metres, or steradians)",
          .blend = kAccumulate};
}

}  // namespace caustics
