// What a pass left in its targets, for those who write it to files or hash it.
#pragma once
#include <functional>

#include "app/frame.hpp"

namespace caustics::app {

// Calls `use` with each attachment that the pass wrote, colours first, depth last.
void for_each_attachment(const RenderedFrame& frame, const PlannedPass& pass,
                         const std::function<void(const PlannedTexture& texture, const Image& image)>& use);

}  // namespace caustics::app
