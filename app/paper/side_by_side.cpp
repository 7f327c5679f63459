#include "app/paper/side_by_side.hpp"

#include <algorithm>

#include "app/output/display_pair.hpp"
#include "app/study/difference_picture.hpp"

namespace caustics::app {

namespace {

constexpr int kShotGap = 4;  // pixels between panels

void put(Image& page, const Image& panel, int left, int bottom) {
  for (int y = 0; y < panel.height(); ++y)
    for (int x = 0; x < panel.width(); ++x)
      for (int c = 0; c < 3; ++c) page.at(left + x, bottom + y, c) = panel.at(x, y, c);
}

// The 99th percentile of what is lit, as study's pictures have it.
double white_of(const Image& truth) {
  std::vector<double> lit;
  for (int y = 0; y < truth.height(); ++y)
    for (int x = 0; x < truth.width(); ++x) {
      const float most = std::max({truth.at(x, y, 0), truth.at(x, y, 1), truth.at(x, y, 2)});
      if (most > 0.0f) lit.push_back(static_cast<double>(most));
    }
  if (lit.empty()) return 1.0;
  const auto at = lit.end() - 1 - static_cast<std::ptrdiff_t>(lit.size() / 100);
  std::nth_element(lit.begin(), at, lit.end());
  return *at;
}

}  // namespace

Image side_by_side(const std::vector<Image>& tested, const Image& truth) {
  const Image small = small_picture(truth);
  const int wide = small.width() + kShotGap, high = small.height() + kShotGap;
  const int columns = static_cast<int>(tested.size()) + 1;
  Image page(Format::RGBA32F, columns * wide - kShotGap, 2 * high - kShotGap);
  std::fill(page.values.begin(), page.values.end(), 1.0f);
  for (int column = 0; column + 1 < columns; ++column) {
    const Image& image = tested[static_cast<std::size_t>(column)];
    put(page, display_pair(small_picture(image), small).a, column * wide, high);
    put(page, difference_picture(image, truth, white_of(truth)), column * wide, 0);
  }
  put(page, display_pair(small, small).b, (columns - 1) * wide, high);
  return page;
}

}  // namespace caustics::app
