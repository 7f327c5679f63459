// Which pixels a point covers: the square of its size around its place, in steps of 1/256 pixel, as llvmpipe
// 22 rounds them.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace caustics {

// Larger points are drawn with this size, smaller ones than 1 with 1.
inline constexpr float kLargestPointSize = 255.0f;

struct PixelRange {
  int first = 0, last = -1;
};

// Along one axis, from the window coordinate of the centre; not yet cut at the target's edges.
inline PixelRange pixels_of_point(float window, float size) {
  const float clamped = size >= 1.0f ? std::min(size, kLargestPointSize) : 1.0f;
  const float scaled = (window - 0.5f) * 256.0f;
  // Half away from zero, the width a whole number of steps.
  const auto centre = static_cast<std::int64_t>(scaled >= 0.0f ? scaled + 0.5f : scaled - 0.5f);
  const std::int64_t width = std::max<std::int64_t>(256, std::lround(clamped * 256.0f));
  const auto ceil_div_256 = [](std::int64_t v) { return static_cast<int>((v + 255) >> 8); };
  const std::int64_t begin = centre - width / 2;
  return {ceil_div_256(begin), ceil_div_256(begin + width) - 1};
}

}  // namespace caustics
