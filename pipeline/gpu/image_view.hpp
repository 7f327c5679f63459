// An image to read from, without a copy where its texels lie in memory anyway.
#pragma once
#include <memory>
#include <span>
#include <utility>

#include "pipeline/gpu/image.hpp"

namespace caustics {

class ImageView {
 public:
  ImageShape shape;
  std::span<const float> values;  // as Image::values

  ImageView() = default;
  // Texels of somebody else, who must keep them.
  ImageView(const ImageShape& s, std::span<const float> texels) : shape(s), values(texels) {}
  ImageView(const Image& image) : ImageView(image.shape, image.values) {}
  // Its own, shared by its copies.
  ImageView(Image&& image) : shape(image.shape), own_(std::make_shared<const Image>(std::move(image))) {
    values = own_->values;
  }

  int width() const { return shape.width; }
  int height() const { return shape.height; }
  int channels() const { return channel_count(shape.format); }
  float at(int x, int y, int channel) const {
    const auto texel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) + static_cast<std::size_t>(x);
    return values[texel * static_cast<std::size_t>(channels()) + static_cast<std::size_t>(channel)];
  }

  Image copy() const {
    Image image;
    image.shape = shape;
    image.values.assign(values.begin(), values.end());
    return image;
  }

 private:
  std::shared_ptr<const Image> own_;
};

}  // namespace caustics
