// Decodes image files from memory, after looking at their headers ourselves.
//
// Only the one plugin that belongs to the recognised content ever sees the bytes, and only after
// the size in the header has passed the limits.
#pragma once
#include <cstdint>
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
};
ImageHeader sniff_image(std::span<const std::uint8_t> bytes);

// False with a message on failure. Sides and number of pixels above the limits are failures.
bool decode_image(std::span<const std::uint8_t> bytes, ImageKind kind, int max_side, std::uint64_t max_pixels,
                  Pixels& pixels, std::string& problem);

}  // namespace caustics::gltf
