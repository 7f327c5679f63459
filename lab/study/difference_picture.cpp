#include "lab/study/difference_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace caustics::study {

namespace {

using Color = std::array<double, 3>;                                   // display values
constexpr double kPictureDecades = 3.0;                                // from full colour down to black
constexpr Color kMore = {1.0, 0.62, 0.12}, kLess = {0.25, 0.62, 1.0};  // told apart by all kinds of eyes

int box_side(const Image& image) {
  return (std::max(image.width(), image.height()) + kPictureSide - 1) / kPictureSide;
}

// Mean of the box of which x, y is a pixel of the smaller image; boxes at the edge are smaller.
double box_mean(const Image& image, int x, int y, int side, int channel) {
  const int right = std::min((x + 1) * side, image.width()), top = std::min((y + 1) * side, image.height());
  double sum = 0.0;
  for (int j = y * side; j < top; ++j)
    for (int i = x * side; i < right; ++i) sum += static_cast<double>(image.at(i, j, channel));
  return sum / (static_cast<double>(right - x * side) * static_cast<double>(top - y * side));
}

Color sign_color(double difference, double white) {
  if (difference == 0.0) return {0.0, 0.0, 0.0};
  const double level =
      std::clamp(1.0 + std::log10(std::fabs(difference) / white) / kPictureDecades, 0.0, 1.0);
  const Color& full = difference > 0.0 ? kMore : kLess;
  return {full[0] * level, full[1] * level, full[2] * level};
}

}  // namespace

Image small_picture(const Image& image) {
  const int side = box_side(image);
  if (side <= 1) return image;
  Image small(Format::RGBA32F, (image.width() + side - 1) / side, (image.height() + side - 1) / side);
  for (int y = 0; y < small.height(); ++y)
    for (int x = 0; x < small.width(); ++x)
      for (int c = 0; c < 3; ++c) small.at(x, y, c) = static_cast<float>(box_mean(image, x, y, side, c));
  return small;
}

Image difference_picture(const Image& tested, const Image& truth, double white) {
  const Image a = small_picture(tested), b = small_picture(truth);
  Image picture(Format::RGBA32F, a.width(), a.height());
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      double most = 0.0;
      for (int c = 0; c < 3; ++c) {
        const double each = static_cast<double>(a.at(x, y, c)) - static_cast<double>(b.at(x, y, c));
        if (std::fabs(each) > std::fabs(most)) most = each;
      }
      const Color color = sign_color(most, white);
      for (int c = 0; c < 3; ++c)
        picture.at(x, y, c) = static_cast<float>(color[static_cast<std::size_t>(c)]);
    }
  }
  return picture;
}

}  // namespace caustics::study
