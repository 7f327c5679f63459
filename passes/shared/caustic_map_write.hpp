// A caustic map as an attachment: what cells and points alike add to.
#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// With three channels and the number of splats, or, where nothing tints the caustics, with one channel.
inline Format caustic_map_format(const Effects& effects) {
  return effects.coloured_caustics.active ? Format::RGBA32F : Format::R32F;
}

inline Write caustic_map_write() {
  return {
      .name = kCausticMap,
      .meaning =
          "rgb: flux in the texel, relative to the light's intensity (square metres, or steradians), r in "
          "every channel where there is one; a: number of cells and splats, by weight",
      .blend = kAccumulate,
      .format_by = caustic_map_format};
}

}  // namespace caustics
