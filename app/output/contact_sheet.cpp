#include "app/output/contact_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "app/output/color_scale.hpp"
#include "app/output/dot_font.hpp"

namespace caustics::app {

namespace {

// Pixels: the room of a picture, what lies around it, and how large a dot of the font is drawn.
constexpr int kRoomWidth = 176, kRoomHeight = 120, kSheetMargin = 8, kSheetDot = 2;
constexpr int kLineHeight = (kDotRows + 2) * kSheetDot;
constexpr int kCellWidth = kRoomWidth + kSheetMargin;
constexpr int kCellHeight = kRoomHeight + kSheetMargin + 2 * kLineHeight + kSheetMargin;
constexpr int kLeastColumns = 6;
constexpr Color kSheetPaper{0.1, 0.1, 0.1}, kSheetInk{0.9, 0.9, 0.9};

void set(Image& picture, int x, int from_top, const Color& color) {
  const int y = picture.height() - 1 - from_top;
  picture.at(x, y, 0) = static_cast<float>(color.r);
  picture.at(x, y, 1) = static_cast<float>(color.g);
  picture.at(x, y, 2) = static_cast<float>(color.b);
}

// The mean over the texels from x0, y0 up to x1, y1, these left out.
Color mean_of(const Image& picture, int x0, int y0, int x1, int y1) {
  double sum[3] = {};
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      for (int c = 0; c < 3; ++c) sum[c] += static_cast<double>(picture.at(x, y, c));
  const double texels = static_cast<double>(x1 - x0) * static_cast<double>(y1 - y0);
  return {sum[0] / texels, sum[1] / texels, sum[2] / texels};
}

// As large as its room allows, with its own proportions, and a texel at least a pixel wide.
Image fitted(const Image& picture) {
  const int width = picture.width(), height = picture.height();
  const double factor =
      std::min(static_cast<double>(kRoomWidth) / width, static_cast<double>(kRoomHeight) / height);
  Image small(Format::RGBA32F, std::max(1, static_cast<int>(width * factor)),
              std::max(1, static_cast<int>(height * factor)));
  const auto begin = [](int i, int of, int texels) {
    return static_cast<int>(static_cast<std::int64_t>(i) * texels / of);
  };
  for (int y = 0; y < small.height(); ++y)
    for (int x = 0; x < small.width(); ++x) {
      const int x0 = begin(x, small.width(), width), y0 = begin(y, small.height(), height);
      const int x1 = std::max(x0 + 1, begin(x + 1, small.width(), width));
      const int y1 = std::max(y0 + 1, begin(y + 1, small.height(), height));
      set(small, x, small.height() - 1 - y, mean_of(picture, x0, y0, x1, y1));
    }
  return small;
}

void write_line(Image& sheet, int left, int top, const std::string& line) {
  const std::string cut = line.substr(0, kRoomWidth / (kDotAdvance * kSheetDot));
  draw_dots(cut, [&](int column, int row) {
    for (int y = 0; y < kSheetDot; ++y)
      for (int x = 0; x < kSheetDot; ++x)
        set(sheet, left + column * kSheetDot + x, top + row * kSheetDot + y, kSheetInk);
  });
}

}  // namespace

void ContactSheet::add(const Image& picture, const std::string& line, const std::string& below) {
  if (cells_.size() < kMost) cells_.push_back({fitted(picture), line, below});
}

Image ContactSheet::picture() const {
  const int count = static_cast<int>(cells_.size());
  const int columns = std::max(kLeastColumns, static_cast<int>(std::sqrt(static_cast<double>(count))));
  const int rows = (count + columns - 1) / columns;
  Image sheet(Format::RGBA32F, std::min(count, columns) * kCellWidth + kSheetMargin,
              rows * kCellHeight + kSheetMargin);
  for (int y = 0; y < sheet.height(); ++y)
    for (int x = 0; x < sheet.width(); ++x) set(sheet, x, y, kSheetPaper);
  for (int i = 0; i < count; ++i) {
    const Cell& cell = cells_[static_cast<std::size_t>(i)];
    const int left = kSheetMargin + i % columns * kCellWidth, top = kSheetMargin + i / columns * kCellHeight;
    const int x0 = left + (kRoomWidth - cell.small.width()) / 2;
    const int y0 = top + (kRoomHeight - cell.small.height()) / 2;
    for (int y = 0; y < cell.small.height(); ++y)
      for (int x = 0; x < cell.small.width(); ++x)
        set(sheet, x0 + x, y0 + cell.small.height() - 1 - y, mean_of(cell.small, x, y, x + 1, y + 1));
    write_line(sheet, left, top + kRoomHeight + kSheetMargin, cell.line);
    write_line(sheet, left, top + kRoomHeight + kSheetMargin + kLineHeight, cell.below);
  }
  return sheet;
}

}  // namespace caustics::app
