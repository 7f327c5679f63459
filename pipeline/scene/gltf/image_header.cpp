#include <algorithm>
#include <string_view>

#include "pipeline/scene/gltf/image_file.hpp"

namespace caustics::gltf {

namespace {

using Span = std::span<const std::uint8_t>;

bool starts_with(Span bytes, std::string_view text, std::size_t at = 0) {
  if (bytes.size() < at + text.size()) return false;
  return std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    [](char c, std::uint8_t b) { return static_cast<std::uint8_t>(c) == b; });
}

int big_endian(Span bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i) value = value << 8 | bytes[at + static_cast<std::size_t>(i)];
  return value > 0x7FFFFFFFu ? 0 : static_cast<int>(value);
}

// PNG specification 5.3 and 11.2: the first chunk is IHDR, width and height its first fields. All
// chunks up to IEND must be there.
ImageHeader png_header(Span bytes) {
  ImageHeader header{ImageKind::Png, 0, 0, 0, ""};
  if (bytes.size() < 33 || !starts_with(bytes, "IHDR", 12)) {
    header.problem = "is a PNG without its header";
    return header;
  }
  header.width = big_endian(bytes, 16, 4);
  header.height = big_endian(bytes, 20, 4);
  header.bits = bytes[24];
  constexpr int kChannels[] = {1, 4, 3, 4, 2, 4, 4};  // by colour type; odd ones have a palette
  header.channels = kChannels[std::min<std::size_t>(bytes[25], 6)];
  std::size_t at = 8;
  while (bytes.size() - at >= 12) {
    const auto length = static_cast<std::size_t>(big_endian(bytes, at, 4));
    if (length > bytes.size() - at - 12) break;
    if (starts_with(bytes, "IEND", at + 4)) return header;
    at += 12 + length;
  }
  header.problem = "is a PNG that was cut short";
  return header;
}

bool is_frame_marker(int marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

// ITU T.81 annex B: segments up to the frame header; after that only start-of-scan markers are
// counted, which cannot occur inside entropy-coded data.
ImageHeader jpeg_header(Span bytes) {
  ImageHeader header{ImageKind::Jpeg, 0, 0, 0, ""};
  std::size_t at = 2;
  while (at + 9 < bytes.size() && header.width == 0) {
    if (bytes[at] != 0xFF) break;
    const int marker = bytes[at + 1];
    if (marker == 0xFF) {
      ++at;
      continue;
    }
    if (is_frame_marker(marker)) {
      header.height = big_endian(bytes, at + 5, 2);
      header.width = big_endian(bytes, at + 7, 2);
      header.channels = std::clamp<int>(bytes[at + 9], 1, 4);
    }
    at += 2 + static_cast<std::size_t>(big_endian(bytes, at + 2, 2));
  }
  if (header.width == 0 || header.height == 0) header.problem = "is a JPEG without its size";
  for (; at + 1 < bytes.size(); ++at) header.scans += bytes[at] == 0xFF && bytes[at + 1] == 0xDA;
  return header;
}

std::uint32_t little_endian(Span bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = count - 1; i >= 0; --i) value = value << 8 | bytes[at + static_cast<std::size_t>(i)];
  return value;
}

// RFC 9649: a RIFF file whose first chunk is a lossy picture (section 2.5), a lossless one (3.4), or says
// what follows (2.7).
ImageHeader webp_header(Span bytes) {
  ImageHeader header{ImageKind::Webp, 0, 0, 0, ""};
  const bool lossless = starts_with(bytes, "VP8L", 12);
  if (bytes.size() < (lossless ? 25 : 30) || little_endian(bytes, 4, 4) > bytes.size() - 8) {
    header.problem = "is a WebP that was cut short";
    return header;
  }
  if (starts_with(bytes, "VP8 ", 12)) {
    header.width = static_cast<int>(little_endian(bytes, 26, 2) & 0x3FFFu);
    header.height = static_cast<int>(little_endian(bytes, 28, 2) & 0x3FFFu);
  } else if (lossless) {
    const std::uint32_t sides = little_endian(bytes, 21, 4);
    header.width = static_cast<int>(sides & 0x3FFFu) + 1;
    header.height = static_cast<int>(sides >> 14 & 0x3FFFu) + 1;
  } else if (starts_with(bytes, "VP8X", 12)) {
    header.width = static_cast<int>(little_endian(bytes, 24, 3)) + 1;
    header.height = static_cast<int>(little_endian(bytes, 27, 3)) + 1;
    if ((bytes[20] & 0x02u) != 0) header.problem = "is a WebP that moves";
  } else {
    header.problem = "is a WebP without its header";
  }
  return header;
}

// Radiance: text lines, an empty one, then "-Y height +X width". Other orders of the axes are not
// read.
ImageHeader hdr_header(Span bytes) {
  ImageHeader header{ImageKind::Hdr, 0, 0, 0, "is a Radiance image without its size"};
  const std::string text(reinterpret_cast<const char*>(bytes.data()),
                         std::min<std::size_t>(bytes.size(), 65536));
  const std::size_t empty_line = text.find("\n\n");
  if (empty_line == std::string::npos) return header;
  std::size_t at = empty_line + 2;
  const auto number_after = [&](std::string_view label) {
    if (text.compare(at, label.size(), label) != 0) return 0;
    at += label.size();
    int value = 0;
    for (; at < text.size() && text[at] >= '0' && text[at] <= '9' && value < 10'000'000; ++at) {
      value = value * 10 + (text[at] - '0');
    }
    return value;
  };
  header.height = number_after("-Y ");
  header.width = number_after(" +X ");
  if (header.width > 0 && header.height > 0) header.problem.clear();
  return header;
}

}  // namespace

std::uint64_t ImageHeader::decoding_bytes() const {
  const std::uint64_t values = texels() * static_cast<std::uint64_t>(channels);
  switch (kind) {
    case ImageKind::Hdr:
    case ImageKind::Exr:
      return values * sizeof(float);
    case ImageKind::Jpeg:  // a progressive one's coefficients lie in memory, two bytes each
      return values * (scans > 1 ? 3 : 1);
    case ImageKind::Webp:  // OpenImageIO decodes it whole and hands on a copy
      return values * 2;
    default:
      return values * static_cast<std::uint64_t>(bits > 8 ? 2 : 1);
  }
}

ImageHeader sniff_image(Span bytes) {
  if (starts_with(bytes, "\x89PNG\r\n\x1a\n")) return png_header(bytes);
  if (starts_with(bytes, "\xff\xd8\xff")) return jpeg_header(bytes);
  if (starts_with(bytes, "RIFF") && starts_with(bytes, "WEBP", 8)) return webp_header(bytes);
  if (starts_with(bytes, "#?")) return hdr_header(bytes);
  if (starts_with(bytes, "\x76\x2f\x31\x01")) return {ImageKind::Exr, 0, 0, 0, ""};
  ImageHeader header;
  header.problem = "is no PNG, JPEG or WebP";
  if (starts_with(bytes, "\xabKTX ")) header.problem = "is a KTX";
  if (starts_with(bytes, "GIF8")) header.problem = "is a GIF";
  if (starts_with(bytes, "BM")) header.problem = "is a BMP";
  if (starts_with(bytes, "DDS ")) header.problem = "is a DDS";
  return header;
}

}  // namespace caustics::gltf
