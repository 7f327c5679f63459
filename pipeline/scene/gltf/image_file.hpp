// Decodes image files from memory, after looking at their headers ourselves.
//
// Only the one plugin that belongs to the recognised content ever sees the bytes, and only after
// the size in the header has passed the limits.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "pipeline/image_io/image_io.hpp"

namespace caustics::gltf {

enum class ImageKind : std::uint8_t { Unknown, Png, Jpeg, Webp, Hdr, Exr };

// What the first bytes say. Width and height are 0 where they could not be found (always for EXR).
struct ImageHeader {
  ImageKind kind = ImageKind::Unknown;
  int width = 0, height = 0;
  int scans = 0;        // JPEG: a progressive image may have many, each as costly as the image
  std::string problem;  // names other formats; empty when the image may be decoded
  int channels = 4;     // at most: a palette may have transparency
  int bits = 8;         // of a channel
  std::uint64_t texels() const {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  }
  // What decoding takes, in bytes, the decoded texels among it.
  std::uint64_t decoding_bytes() const;
};
ImageHeader sniff_image(std::span<const std::uint8_t> bytes);

// False with a message on failure. Sides and number of pixels above the limits are failures. `before` is
// called with the bytes that decoding takes before they are taken; it may throw.
bool decode_image(std::span<const std::uint8_t> bytes, ImageKind kind, int max_side, std::uint64_t max_pixels,
                  Pixels& pixels, std::string& problem,
                  const std::function<void(std::uint64_t bytes)>& before = {});

}  // namespace caustics::gltf
