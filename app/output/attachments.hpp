// What a pass left in its targets, for those who write it to files, hash it or show it.
#pragma once
#include <array>
#include <functional>
#include <string_view>

#include "app/frame.hpp"

namespace caustics::app {

struct Attachment {
  const PlannedTexture& texture;
  int index = 0;  // of the texture in the plan
  const Image& image;
  std::string_view meaning;    // of a texel, with unit and space
  std::array<float, 4> clear;  // what it was cleared to when its first pass began
};

// Calls `use` with each attachment that the pass wrote, colours first, depth last.
void for_each_attachment(const RenderedFrame& frame, const PlannedPass& pass,
                         const std::function<void(const Attachment& attachment)>& use);

}  // namespace caustics::app
