// One setting rendered: its caustic as the camera sees it, and how long its passes took.
#pragma once
#include <functional>
#include <string>

#include "app/frame.hpp"
#include "app/study_effects.hpp"
#include "lab/study/pass_times.hpp"

namespace caustics::app {

struct Rendered {
  Image caustic;  // aov_caustic: lux; rows from the bottom
  std::string device;
  std::uint64_t texture_bytes = 0;  // of all textures that the timed passes write
  study::FrameTimes times;
};

// Renders once to warm up and for the image, then `repeat` times for the times, of which there are
// none with 0. `say` hears what is going on. Throws Error as `render` does, NumericFault where the
// caustic has a NaN or an infinity. `without`: what is left out, or null.
Rendered render_setting(FrameRequest request, int repeat, const std::function<void(const std::string&)>& say,
                        const Omission* without = nullptr);

}  // namespace caustics::app
