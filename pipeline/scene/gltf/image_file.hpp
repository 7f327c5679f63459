// Decodes image files from memory with OpenImageIO, after looking at their headers ourselves.
//
// Only the one plugin that belongs to the recognised content ever sees the bytes, and only after
// the size in the header has passed the limits.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace caustics::gltf {

enum class ImageKind : std::uint8_t { Unknown, Png, Jpeg, Hdr, Exr };

// What the first bytes say. Width and height are 0 where they could not be found (always for EXR).
struct ImageHeader {
  ImageKind kind = ImageKind::Unknown;
  int width = 0, height = 0;
  int scans = 0;        // JPEG: a progressive image may have many, each as costly as the image
  std::string problem;  // names other formats; empty when the image may be decoded
};
ImageHeader sniff_image(std::span<const std::uint8_t> bytes);

// Texels as stored in the file, top row first: 8 or 16 bits per channel, or floats.
struct Pixels {
  int width = 0, height = 0, channels = 0;
  double largest = 255;                 // what stands for 1: 255 or 65535
  std::vector<std::uint16_t> integers;  // PNG and JPEG
  std::vector<float> floats;            // HDR and EXR
};

// False with a message on failure. Sides and number of pixels above the limits are failures.
bool decode_image(std::span<const std::uint8_t> bytes, ImageKind kind, int max_side, std::uint64_t max_pixels,
                  Pixels& pixels, std::string& problem);

}  // namespace caustics::gltf
