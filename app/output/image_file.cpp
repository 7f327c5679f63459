#include "app/output/image_file.hpp"

#include <algorithm>

#include "app/shell/atomic_file.hpp"
#include "app/shell/interrupt.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/image_io/image_io.hpp"

namespace caustics::app {

namespace {

// Encodes into memory, row by row from the top; what reaches the disk is left to write_atomically.
void write_encoded(const std::filesystem::path& path, ImageToEncode image) {
  image.row = [fill = std::move(image.row)](int row, void* values) {
    if (row % 256 == 0) stop_if_interrupted();
    fill(row, values);
  };
  std::vector<unsigned char> bytes;
  const std::string problem = image_io().encode(image, bytes);
  if (!problem.empty()) {
    throw Error(ExitCode::CannotWrite, path.string() + ": cannot encode: " + problem);
  }
  write_atomically(path, bytes.data(), bytes.size());
}

float value_of(const ExrChannel& channel, int x, int y) {
  const float value = channel.image->at(x, y, channel.channel);
  const bool covered = channel.covered_by < 0 || channel.image->at(x, y, channel.covered_by) != 0.0f;
  if (channel.offset == 0.0 || !covered) return value;
  return static_cast<float>(static_cast<double>(value) + channel.offset);
}

}  // namespace

bool is_image_of_size(const std::filesystem::path& path, int width, int height) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  int found_width = 0, found_height = 0;
  return image_io().read_size(path, found_width, found_height) && found_width == width &&
         found_height == height;
}

void write_png(const std::filesystem::path& path, const Image& picture) {
  const auto fill = [&](int row, void* values) {
    auto* bytes = static_cast<std::uint8_t*>(values);
    for (int x = 0; x < picture.width(); ++x) {
      for (int c = 0; c < 3; ++c) *bytes++ = unorm8_from_float(picture.at(x, picture.height() - 1 - row, c));
    }
  };
  write_encoded(path, {ImageEncoding::Png, picture.width(), picture.height(), {"R", "G", "B"}, fill});
}

void write_exr(const std::filesystem::path& path, const std::vector<ExrChannel>& channels) {
  const int width = channels.front().image->width(), height = channels.front().image->height();
  const auto fill = [&](int row, void* values) {
    for (std::size_t c = 0; c < channels.size(); ++c) {
      auto* floats = static_cast<float*>(values) + c;
      for (int x = 0; x < width; ++x, floats += channels.size()) {
        *floats = value_of(channels[c], x, height - 1 - row);
      }
    }
  };
  ImageToEncode image{ImageEncoding::Exr, width, height, {}, fill};
  for (const ExrChannel& channel : channels) image.channels.push_back(channel.name);
  write_encoded(path, std::move(image));
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
