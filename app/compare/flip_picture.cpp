#include "app/compare/flip_picture.hpp"

#include <algorithm>
#include <string_view>

#include "app/output/color_scale.hpp"
#include "app/output/dot_font.hpp"

namespace caustics::app {

namespace {

constexpr Color kPaper = {0.15, 0.15, 0.15}, kInk = {1.0, 1.0, 1.0}, kLeftOut = {0.4, 0.4, 0.4};
// Sizes of the scale, pixels: margins, the bar's height, and how large a dot of the font is drawn.
constexpr int kMargin = 12, kGap = 6, kBar = 12, kDot = 2;
constexpr int kLeastWidth = 180;
constexpr int kLegend = kGap + kBar + kGap + 5 * kDot + kGap;

void put(Image& picture, int x, int from_top, const Color& color) {
  if (x < 0 || x >= picture.width()) return;
  const int y = picture.height() - 1 - from_top;
  picture.at(x, y, 0) = static_cast<float>(color.r);
  picture.at(x, y, 1) = static_cast<float>(color.g);
  picture.at(x, y, 2) = static_cast<float>(color.b);
}

void write(Image& picture, int left, int top, std::string_view text) {
  draw_dots(text, [&](int column, int row) {
    for (int y = 0; y < kDot; ++y)
      for (int x = 0; x < kDot; ++x) put(picture, left + column * kDot + x, top + row * kDot + y, kInk);
  });
}

// The bar with its numbers, `top` rows below the picture's top.
void draw_scale(Image& picture, int top) {
  const int length = picture.width() - 2 * kMargin;
  for (int x = 0; x < length; ++x) {
    const Color color = cubehelix(static_cast<double>(x) / (length - 1));
    for (int y = 0; y < kBar; ++y) put(picture, kMargin + x, top + kGap + y, color);
  }
  constexpr std::string_view kLabels[] = {"0", "0.25", "0.5", "0.75", "1"};
  for (int i = 0; i < 5; ++i) {
    const int x = kMargin + (length - 1) * i / 4;
    for (int y = 0; y < kGap - 2; ++y) put(picture, x, top + kGap + kBar + y, kInk);
    write(picture, x - dot_width(kLabels[i]) * kDot / 2, top + 2 * kGap + kBar, kLabels[i]);
  }
}

}  // namespace

Image flip_picture(const Image& map, const Selection& selection) {
  Image picture(Format::RGBA32F, std::max(map.width(), kLeastWidth), map.height() + kLegend);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) put(picture, x, y, kPaper);
  }
  const int left = (picture.width() - map.width()) / 2;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const auto error = static_cast<double>(map.at(x, map.height() - 1 - y, 0));
      put(picture, left + x, y, selection.has(x, y) ? cubehelix(error) : kLeftOut);
    }
  }
  draw_scale(picture, map.height());
  return picture;
}

}  // namespace caustics::app
