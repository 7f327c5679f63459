#include "app/output/image_file.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "app/shell/atomic_file.hpp"
#include "app/shell/interrupt.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

// Encodes into memory, row by row from the top; what reaches the disk is left to write_atomically.
class Encoder {
 public:
  Encoder(const std::filesystem::path& path, const char* format, const OIIO::ImageSpec& spec)
      : path_(path), output_(OIIO::ImageOutput::create(format)) {
    if (!output_ || !output_->supports("ioproxy")) {
      fail(std::string("this OpenImageIO cannot encode ") + format + " in memory");
    }
    output_->set_ioproxy(&memory_);
    if (!output_->open(std::string("memory.") + format, spec)) fail(output_->geterror());
  }

  void row(int from_top, const OIIO::TypeDesc& type, const void* values) {
    if (!output_->write_scanline(from_top, 0, type, values)) fail(output_->geterror());
    if (from_top % 256 == 0) stop_if_interrupted();
  }

  void finish() {
    if (!output_->close()) fail(output_->geterror());
    write_atomically(path_, bytes_.data(), bytes_.size());
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw Error(ExitCode::CannotWrite, path_.string() + ": cannot encode: " + why);
  }

  std::filesystem::path path_;
  std::vector<unsigned char> bytes_;
  OIIO::Filesystem::IOVecOutput memory_{bytes_};
  std::unique_ptr<OIIO::ImageOutput> output_;
};

}  // namespace

bool is_image_of_size(const std::filesystem::path& path, int width, int height) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) {
    OIIO::geterror();  // fetched, so that nobody else finds it
    return false;
  }
  return input->spec().width == width && input->spec().height == height;
}

void write_png(const std::filesystem::path& path, const Image& picture) {
  OIIO::ImageSpec spec(picture.width(), picture.height(), 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  Encoder encoder(path, "png", spec);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(picture.width()) * 3);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      for (int c = 0; c < 3; ++c) {
        row[static_cast<std::size_t>(x) * 3 + static_cast<std::size_t>(c)] =
            unorm8_from_float(picture.at(x, picture.height() - 1 - y, c));
      }
    }
    encoder.row(y, OIIO::TypeDesc::UINT8, row.data());
  }
  encoder.finish();
}

void write_exr(const std::filesystem::path& path, const std::vector<ExrChannel>& channels) {
  const int width = channels.front().image->width(), height = channels.front().image->height();
  const std::size_t count = channels.size();
  OIIO::ImageSpec spec(width, height, static_cast<int>(count), OIIO::TypeDesc::FLOAT);
  spec.attribute("compression", "zip");
  spec.attribute("oiio:ColorSpace", "Linear");
  // OpenImageIO would put the present time here, and no two files would be equal.
  spec.attribute("DateTime", "");
  spec.channelnames.clear();
  for (const ExrChannel& channel : channels) spec.channelnames.push_back(channel.name);
  Encoder encoder(path, "exr", spec);
  std::vector<float> row(static_cast<std::size_t>(width) * count);
  for (int y = 0; y < height; ++y) {
    for (std::size_t c = 0; c < count; ++c) {
      const ExrChannel& from = channels[c];
      for (int x = 0; x < width; ++x) {
        float value = from.image->at(x, height - 1 - y, from.channel);
        const bool covered =
            from.covered_by < 0 || from.image->at(x, height - 1 - y, from.covered_by) != 0.0f;
        if (from.offset != 0.0 && covered) {
          value = static_cast<float>(static_cast<double>(value) + from.offset);
        }
        row[static_cast<std::size_t>(x) * count + c] = value;
      }
    }
    encoder.row(y, OIIO::TypeDesc::FLOAT, row.data());
  }
  encoder.finish();
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
