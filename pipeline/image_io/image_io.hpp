// What OpenImageIO does for this project, without its headers. It stands in a module of its own that is
// loaded when the first image is read or written that is no PNG or JPEG texture (png_and_jpeg.hpp), nor a PNG
// to write: OpenImageIO brings some 260 shared libraries, and loading them takes longer than most commands
// and tests.
#pragma once
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/gpu/difference.hpp"

namespace caustics {

// Texels as stored in the file, top row first: 8 or 16 bits per channel, or floats.
struct Pixels {
  int width = 0, height = 0, channels = 0;
  double largest = 255;                 // what stands for 1: 255 or 65535
  std::vector<std::uint8_t> bytes;      // PNG, JPEG and WebP of 8 bits,
  std::vector<std::uint16_t> integers;  // and of 16
  std::vector<float> floats;            // HDR and EXR
};

struct ImageToDecode {
  std::span<const std::uint8_t> bytes;
  std::string format;   // of OpenImageIO: "jpeg", "webp", "hdr", "openexr"
  bool floats = false;  // else integers
  // Why an image of this size is refused, asked before memory is taken for it; empty: it is not.
  std::function<std::string(std::int64_t width, std::int64_t height, int channels)> refusal;
};

// One channel of a file. Row 0 is the top.
struct Plane {
  std::string name;
  ChannelView view;
  int left = 0, top = 0;  // of the data window; 0, 0 but for some EXR files
  bool integers = false;  // stored as such: display values (sRGB), where they are colours
};

struct ImagePlanes {
  std::deque<std::vector<float>> storage;  // what the views look into
  std::vector<Plane> planes;               // in the file's order, each name once

  ImagePlanes() = default;
  ImagePlanes(ImagePlanes&&) = default;
  ImagePlanes& operator=(ImagePlanes&&) = default;
};

// EXR: 32-bit floats, ZIP-compressed. HDR (Radiance): floats that share an exponent. Display values, 0..1:
// TIFF of 16 bits, JPEG of quality 92.
enum class ImageFormat { Exr, Hdr, Tiff, Jpeg };

struct ImageToEncode {
  ImageFormat format = ImageFormat::Exr;
  int width = 0, height = 0;
  std::vector<std::string> channels;  // names
  // Writes the row's values, channel by channel in each pixel. Row 0 is the top.
  std::function<void(int row, float* values)> row;
};

// The module's functions. Those that return a string say what went wrong; empty: nothing did. What a callback
// throws passes through.
struct ImageIo {
  const char* version = "";  // of OpenImageIO
  std::string (*decode)(const ImageToDecode& image, Pixels& pixels) = nullptr;
  // Every channel of every part of a file, values as they are stored: no colour is transformed, alpha not
  // multiplied; integers become 0..1. Channels of a file of several parts are named PART.CHANNEL, unless
  // their names begin so already. `next_part` is called after each part. Refused: damaged, deep or volumetric
  // images, and channels of 32-bit integers, which floats do not hold.
  std::string (*read_planes)(const std::filesystem::path& path, const std::function<void()>& next_part,
                             ImagePlanes& planes) = nullptr;
  // From the head of a file. False: it holds no image.
  bool (*read_size)(const std::filesystem::path& path, int& width, int& height) = nullptr;
  std::string (*encode)(const ImageToEncode& image, std::vector<unsigned char>& bytes) = nullptr;
};

// Loads the module at the first call: from beside the program that runs, from the library folder of the
// installation that the program is part of, or from where this library was built or installed. Throws Error
// (BackendUnavailable) with the loader's reason.
const ImageIo& image_io();
// Has it been loaded? Loading takes kImageIoBytes, measured with Debian 12's OpenImageIO.
bool is_image_io_loaded();
inline constexpr std::uint64_t kImageIoBytes = 134'000'000;

}  // namespace caustics
