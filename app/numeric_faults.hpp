// What a frame holds that cannot be light: it is named, and no picture is written.
#pragma once
#include <string>

namespace caustics::app {

class RenderedFrame;

// Throws Error (NumericFault) where an image of the frame (beauty, or what --aov names) has a NaN or an
// infinity, or is brighter than the scene's lights can make anything (pipeline/measure/brightness_bound.hpp).
// `which`: said before it, "frame 3: ".
void refuse_numeric_faults(const RenderedFrame& frame, const std::string& texture, const std::string& which);

}  // namespace caustics::app
