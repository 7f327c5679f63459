// Stands in for gltf/image_file.cpp where there is no OpenImageIO. It reads what the sample scenes hold and
// no more: PNG files of 8 bits a channel, not interlaced, stored without compression and filters.
#include <string_view>

#include "pipeline/scene/gltf/image_file.hpp"

namespace caustics::gltf {

namespace {

using Bytes = std::vector<std::uint8_t>;

std::size_t big_endian(std::span<const std::uint8_t> bytes) {
  std::size_t value = 0;
  for (const std::uint8_t byte : bytes.first(4)) value = value << 8 | byte;
  return value;
}

// The data of all IDAT chunks; sniff_image has followed the chunks to their end.
Bytes compressed_data(std::span<const std::uint8_t> file) {
  Bytes data;
  for (std::size_t at = 8; file.size() - at >= 12;) {
    const std::size_t length = big_endian(file.subspan(at));
    const std::string_view kind(reinterpret_cast<const char*>(file.data()) + at + 4, 4);
    if (kind == "IEND" || length > file.size() - at - 12) break;
    const auto chunk = file.subspan(at + 8, length);
    if (kind == "IDAT") data.insert(data.end(), chunk.begin(), chunk.end());
    at += 12 + length;
  }
  return data;
}

// RFC 1950 and RFC 1951 3.2.4: two bytes of zlib's header, then stored blocks. False for any other block.
bool stored_bytes(const Bytes& data, Bytes& stored) {
  std::size_t at = 2;
  for (bool last = false; !last;) {
    if (at + 5 > data.size() || data[at] > 1) return false;
    last = data[at] == 1;
    const std::size_t length = data[at + 1] | static_cast<std::size_t>(data[at + 2]) << 8;
    if (length > data.size() - at - 5) return false;
    const auto begin = data.begin() + static_cast<std::ptrdiff_t>(at + 5);
    stored.insert(stored.end(), begin, begin + static_cast<std::ptrdiff_t>(length));
    at += 5 + length;
  }
  return true;
}

// Rows from the top, each behind the number of its filter; 0 is none (PNG specification 7.3, 9.2).
bool unfiltered(const Bytes& stored, Pixels& pixels) {
  const std::size_t row = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.channels);
  const auto height = static_cast<std::size_t>(pixels.height);
  if (stored.size() != height * (row + 1)) return false;
  pixels.integers.clear();  // those of the picture before this one
  for (std::size_t y = 0; y < height; ++y) {
    if (stored[y * (row + 1)] != 0) return false;
    const auto begin = stored.begin() + static_cast<std::ptrdiff_t>(y * (row + 1) + 1);
    pixels.bytes.insert(pixels.bytes.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
  }
  return true;
}

int channels_of(int colour_type) {
  constexpr int kChannels[] = {1, 0, 3, 0, 2, 0, 4};
  return colour_type < 7 ? kChannels[colour_type] : 0;
}

}  // namespace

bool decode_image(std::span<const std::uint8_t> bytes, ImageKind kind, int max_side, std::uint64_t max_pixels,
                  Pixels& pixels, std::string& problem, const std::function<void(std::uint64_t bytes)>&) {
  const ImageHeader header = sniff_image(bytes);
  problem = "cannot be decoded: this build reads uncompressed PNG files of 8 bits only";
  if (kind != ImageKind::Png || header.kind != kind || !header.problem.empty()) return false;
  const auto count = static_cast<std::uint64_t>(header.width) * static_cast<std::uint64_t>(header.height);
  if (header.width > max_side || header.height > max_side || count > max_pixels) return false;
  pixels.width = header.width;
  pixels.height = header.height;
  pixels.channels = channels_of(bytes[25]);
  Bytes stored;
  const bool plain = bytes[24] == 8 && bytes[28] == 0 && pixels.channels > 0;
  if (!plain || !stored_bytes(compressed_data(bytes), stored) || !unfiltered(stored, pixels)) return false;
  problem.clear();
  return true;
}

}  // namespace caustics::gltf
