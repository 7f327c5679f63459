// Texels in memory.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/gpu/format.hpp"

namespace caustics {

struct ImageShape {
  Format format = Format::RGBA32F;
  int width = 0;
  int height = 0;
  bool operator==(const ImageShape&) const = default;
};

// Rows run from the bottom (row 0) to the top, as OpenGL stores them; only the file writers turn
// pictures over. Channels are interleaved floats whatever the format: half and 8-bit texels are held
// as the float they stand for, so that format conversion happens in one place (stored_value).
struct Image {
  ImageShape shape;
  std::vector<float> values;  // width * height * channel_count(format)

  Image() = default;
  Image(Format format, int width, int height);  // all zeros

  int width() const { return shape.width; }
  int height() const { return shape.height; }
  int channels() const { return channel_count(shape.format); }
  float& at(int x, int y, int channel) { return values[index(x, y, channel)]; }
  float at(int x, int y, int channel) const { return values[index(x, y, channel)]; }

 private:
  std::size_t index(int x, int y, int channel) const {
    const auto texel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) + static_cast<std::size_t>(x);
    return texel * static_cast<std::size_t>(channels()) + static_cast<std::size_t>(channel);
  }
};

// SHA-256 in hexadecimal of the texels as a GPU stores them (bytes_per_texel, little endian, row 0
// first), preceded by format name, width and height. -0 and NaN payloads are hashed as they are.
std::string sha256(const Image& image);

// Number of values that are NaN or infinite.
std::size_t count_non_finite(const Image& image);

}  // namespace caustics
