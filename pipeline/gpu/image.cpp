#include "pipeline/gpu/image.hpp"

#include <bit>
#include <cmath>
#include <cstring>

#include "pipeline/gpu/sha256.hpp"

namespace caustics {

namespace {

void append_little_endian(std::vector<std::uint8_t>& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

}  // namespace

Image::Image(Format format, int width, int height)
    : shape{format, width, height},
      values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
             static_cast<std::size_t>(channel_count(format))) {}

std::string sha256(const Image& image) {
  Sha256 hash;
  const std::string header = std::string(format_name(image.shape.format)) + ' ' +
                             std::to_string(image.width()) + ' ' + std::to_string(image.height()) + '\n';
  hash.add(header.data(), header.size());
  if (std::endian::native == std::endian::little &&
      bytes_per_texel(image.shape.format) == sizeof(float) * static_cast<std::size_t>(image.channels()) &&
      image.shape.format != Format::RGBA8) {
    hash.add(image.values.data(), image.values.size() * sizeof(float));
    return hash.hexadecimal();
  }
  std::vector<std::uint8_t> bytes;
  bytes.reserve(1 << 16);
  for (const float value : image.values) {
    switch (image.shape.format) {
      case Format::R32F:
      case Format::RG32F:
      case Format::RGBA32F:
      case Format::Depth32F:
        append_little_endian(bytes, std::bit_cast<std::uint32_t>(value), 4);
        break;
      case Format::RGBA16F:
        append_little_endian(bytes, half_from_float(value), 2);
        break;
      case Format::RGBA8:
        bytes.push_back(unorm8_from_float(value));
        break;
    }
    if (bytes.size() >= (1 << 16) - 4) {
      hash.add(bytes.data(), bytes.size());
      bytes.clear();
    }
  }
  hash.add(bytes.data(), bytes.size());
  return hash.hexadecimal();
}

std::size_t count_non_finite(const Image& image) {
  std::size_t count = 0;
  for (const float value : image.values) count += std::isfinite(value) ? 0u : 1u;
  return count;
}

}  // namespace caustics
