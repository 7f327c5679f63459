#include "app/side_by_side.hpp"

#include <algorithm>

#include "app/output/display_pair.hpp"
#include "lab/study/difference_picture.hpp"
#include "lab/study/truth.hpp"

namespace caustics::app {

using study::difference_picture;
using study::small_picture;

namespace {

constexpr int kShotGap = 4;  // pixels between panels

void put(Image& page, const Image& panel, int left, int bottom) {
  for (int y = 0; y < panel.height(); ++y)
    for (int x = 0; x < panel.width(); ++x)
      for (int c = 0; c < 3; ++c) page.at(left + x, bottom + y, c) = panel.at(x, y, c);
}

}  // namespace

Image side_by_side(const std::vector<Image>& tested, const Image& truth) {
  const Image small = small_picture(truth);
  const double lit = study::white_of(truth), white = lit > 0.0 ? lit : 1.0;
  const int wide = small.width() + kShotGap, high = small.height() + kShotGap;
  const int columns = static_cast<int>(tested.size()) + 1;
  Image page(Format::RGBA32F, columns * wide - kShotGap, 2 * high - kShotGap);
  std::fill(page.values.begin(), page.values.end(), 1.0f);
  for (int column = 0; column + 1 < columns; ++column) {
    const Image& image = tested[static_cast<std::size_t>(column)];
    put(page, display_pair(small_picture(image), small).a, column * wide, high);
    put(page, difference_picture(image, truth, white), column * wide, 0);
  }
  put(page, display_pair(small, small).b, (columns - 1) * wide, high);
  return page;
}

}  // namespace caustics::app
