#include "app/compare/block_means.hpp"

#include <algorithm>

namespace caustics::app {

namespace {

float mean_of(const ChannelView& view, int left, int top, int side) {
  const int right = std::min(left + side, view.width), bottom = std::min(top + side, view.height);
  double sum = 0.0;
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) sum += static_cast<double>(view.at(x, y));
  return static_cast<float>(sum / (static_cast<double>(right - left) * static_cast<double>(bottom - top)));
}

}  // namespace

void take_block_means(ImagePlanes& image, int side) {
  std::deque<std::vector<float>> storage;  // does not move what it holds
  for (Plane& plane : image.planes) {
    std::vector<float> means;
    for (int y = 0; y < plane.view.height; y += side)
      for (int x = 0; x < plane.view.width; x += side) means.push_back(mean_of(plane.view, x, y, side));
    const auto blocks = [&](int texels) { return (texels + side - 1) / side; };
    storage.push_back(std::move(means));
    plane.view = {.first = storage.back().data(),
                  .width = blocks(plane.view.width),
                  .height = blocks(plane.view.height)};
  }
  image.storage = std::move(storage);
}

}  // namespace caustics::app
