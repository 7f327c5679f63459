// The picture in finer steps than its texture's 8 bits a channel.
#pragma once
#include "app/frame.hpp"

namespace caustics::app {

// Draws the pass that writes `picture` once more, into floats. What it reads must have been kept.
Image fine_picture(const RenderedFrame& frame);
// The textures beside `picture` that a frame keeps for it.
inline constexpr const char* kForFinePicture = "beauty";

}  // namespace caustics::app
