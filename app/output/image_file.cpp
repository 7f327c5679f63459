#include "app/output/image_file.hpp"

#include <png.h>

#include <cstdint>
#include <cstdio>
#include <vector>

#include "app/shell/atomic_file.hpp"
#include "app/shell/interrupt.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

// Wherever it breaks off: what reaches the disk is left to write_atomically.
void look_for_interruption(int row) {
  if (row % 256 == 0) stop_if_interrupted();
}

[[noreturn]] void refuse_to_encode(const std::filesystem::path& path, const std::string& problem) {
  throw Error(ExitCode::CannotWrite, path.string() + ": cannot encode: " + problem);
}

float value_of(const ExrChannel& channel, int x, int y) {
  const float value = channel.image->at(x, y, channel.channel);
  const bool covered = channel.covered_by < 0 || channel.image->at(x, y, channel.covered_by) != 0.0f;
  if (channel.offset == 0.0 || !covered) return value;
  return static_cast<float>(static_cast<double>(value) + channel.offset);
}

void write_encoded(const std::filesystem::path& path, const ImageToEncode& image) {
  std::vector<unsigned char> bytes;
  const std::string problem = image_io().encode(image, bytes);
  if (!problem.empty()) refuse_to_encode(path, problem);
  write_atomically(path, bytes.data(), bytes.size());
}

}  // namespace

bool is_image_of_size(const std::filesystem::path& path, int width, int height) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  int found_width = 0, found_height = 0;
  return image_io().read_size(path, found_width, found_height) && found_width == width &&
         found_height == height;
}

// By libpng itself: OpenImageIO takes longer to load than a picture to write.
void write_png(const std::filesystem::path& path, const ImageView& picture) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(picture.width());
  png.height = static_cast<png_uint_32>(picture.height());
  png.format = PNG_FORMAT_RGB;  // 8-bit sRGB
  std::vector<std::uint8_t> texels(PNG_IMAGE_SIZE(png));
  std::uint8_t* out = texels.data();
  for (int row = 0; row < picture.height(); ++row) {
    look_for_interruption(row);
    for (int x = 0; x < picture.width(); ++x)
      for (int c = 0; c < 3; ++c) *out++ = unorm8_from_float(picture.at(x, picture.height() - 1 - row, c));
  }
  std::vector<std::uint8_t> bytes(PNG_IMAGE_PNG_SIZE_MAX(png));
  png_alloc_size_t size = bytes.size();
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, texels.data(), 0, nullptr))
    refuse_to_encode(path, png.message);
  write_atomically(path, bytes.data(), size);
}

void write_picture(const std::filesystem::path& path, ImageFormat format, const ImageView& picture) {
  ImageToEncode image;
  image.format = format;
  image.width = picture.width();
  image.height = picture.height();
  image.channels = {"R", "G", "B"};
  image.row = [&](int row, float* values) {
    look_for_interruption(row);
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) *values++ = picture.at(x, image.height - 1 - row, c);
  };
  write_encoded(path, image);
}

void write_exr(const std::filesystem::path& path, const std::vector<ExrChannel>& channels) {
  const int width = channels.front().image->width(), height = channels.front().image->height();
  ImageToEncode image;
  image.width = width;
  image.height = height;
  for (const ExrChannel& channel : channels) image.channels.push_back(channel.name);
  image.row = [&](int row, float* values) {
    look_for_interruption(row);
    for (int x = 0; x < width; ++x)
      for (const ExrChannel& channel : channels) *values++ = value_of(channel, x, height - 1 - row);
  };
  write_encoded(path, image);
}

std::vector<ExrChannel> channels_of(const Image& image) {
  constexpr const char* kNames[] = {"R", "G", "B", "A"};
  std::vector<ExrChannel> channels;
  channels.reserve(4);
  for (int c = 0; c < image.channels(); ++c) {
    channels.push_back({is_depth(image.shape.format) ? "Z" : kNames[c], &image, c, 0.0, -1});
  }
  return channels;
}

}  // namespace caustics::app
