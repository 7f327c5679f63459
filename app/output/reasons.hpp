// What `render -v` adds on stderr: the effects and passes of a frame that was drawn.
#pragma once
#include <vector>

#include "app/frame.hpp"

namespace caustics::app {

// Why each effect is called for or not; each pass with its time and reason; what did not run, and why.
void print_reasons(const RenderedFrame& frame, const std::vector<PassReport>& reports);

}  // namespace caustics::app
