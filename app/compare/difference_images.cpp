#include "app/compare/difference_images.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/output/color_scale.hpp"
#include "app/output/image_file.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

// Channels that were compared.
std::vector<const ChannelDifference*> drawable(const PlanesDifference& difference) {
  std::vector<const ChannelDifference*> channels;
  for (const ChannelDifference& channel : difference.channels) {
    if (channel.mismatch.empty()) channels.push_back(&channel);
  }
  return channels;
}

// A - B; 0 where both are the same infinity or the texel is not selected, NaN where either is NaN.
// Rows from the bottom.
Image signed_difference(const ChannelDifference& channel, const Selection& selection) {
  const ChannelView& a = channel.a->view;
  Image image(Format::R32F, a.width, a.height);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      if (!selection.has(x, y)) continue;
      const float in_a = a.at(x, y), in_b = channel.b->view.at(x, y);
      image.at(x, a.height - 1 - y, 0) = in_a == in_b ? 0.0f : in_a - in_b;
    }
  }
  return image;
}

double magnitude_at(const std::vector<Image>& images, int x, int y) {
  double magnitude = 0.0;
  for (const Image& image : images) {
    const double value = std::abs(static_cast<double>(image.at(x, y, 0)));
    if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
    magnitude = std::max(magnitude, value);
  }
  return magnitude;
}

Image color_picture(const std::vector<Image>& images, double largest) {
  Image picture(Format::RGBA32F, images[0].width(), images[0].height());
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const Color color = logarithmic_color(magnitude_at(images, x, y), darkest_of(largest), largest);
      picture.at(x, y, 0) = static_cast<float>(color.r);
      picture.at(x, y, 1) = static_cast<float>(color.g);
      picture.at(x, y, 2) = static_cast<float>(color.b);
    }
  }
  return picture;
}

double largest_magnitude(const std::vector<Image>& images) {
  double largest = 0.0;
  for (const Image& image : images) {
    for (const float value : image.values) {
      if (std::isfinite(value)) largest = std::max(largest, std::abs(static_cast<double>(value)));
    }
  }
  return largest;
}

std::string scale_text(double largest) {
  if (largest == 0.0) return "black is equal, magenta is NaN or infinite";
  return "black is equal, white is a difference of " + significant(largest, 3) + ", darkest before black " +
         significant(darkest_of(largest), 3) + " and less, logarithmic; magenta is NaN or infinite";
}

}  // namespace

std::string why_not_drawable(const PlanesDifference& difference) {
  const std::vector<const ChannelDifference*> channels = drawable(difference);
  if (channels.empty()) return "the images have no channel of one name and size";
  const ChannelView& first = channels.front()->a->view;
  for (const ChannelDifference* channel : channels) {
    const ChannelView& view = channel->a->view;
    if (view.width != first.width || view.height != first.height) {
      return "the channels are of several sizes";
    }
  }
  return "";
}

std::string write_difference_images(const DifferencePaths& paths, const PlanesDifference& difference,
                                    const Selection& selection) {
  const std::vector<const ChannelDifference*> channels = drawable(difference);
  std::vector<Image> images;
  images.reserve(channels.size());
  std::vector<ExrChannel> named;
  for (const ChannelDifference* channel : channels) {
    images.push_back(signed_difference(*channel, selection));
    named.push_back({channel->name, &images.back(), 0, 0.0, -1});
  }
  const double largest = largest_magnitude(images);
  write_exr(paths.signed_exr, named);
  write_png(paths.color_png, color_picture(images, largest));
  return scale_text(largest);
}

}  // namespace caustics::app
