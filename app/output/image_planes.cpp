#include "app/output/image_planes.hpp"

#include <OpenImageIO/imageio.h>

#include <algorithm>

#include "app/shell/interrupt.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

namespace fs = std::filesystem;

// A header may promise any size; more than this is not allocated on its word alone.
constexpr std::int64_t kMostValues = std::int64_t{1} << 32;
constexpr int kMostParts = 1024;

[[noreturn]] void refuse_image(const fs::path& path, const std::string& why) {
  throw Error(ExitCode::BadInput, path.string() + ": " + why);
}

// What OpenImageIO says, without the line breaks and the file name that it may add.
std::string reason(std::string message) {
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
  std::replace(message.begin(), message.end(), '\n', ' ');
  return message.empty() ? "the data are damaged" : message;
}

std::unique_ptr<OIIO::ImageInput> open_image(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) refuse_image(path, "no such file");
  if (!fs::is_regular_file(path, error)) refuse_image(path, "is not a plain file");
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) refuse_image(path, "is no image that can be read: " + reason(OIIO::geterror()));
  return input;
}

bool is_wide_integer(const OIIO::TypeDesc& type) {
  return type.basetype == OIIO::TypeDesc::UINT32 || type.basetype == OIIO::TypeDesc::INT32 ||
         type.basetype == OIIO::TypeDesc::UINT64 || type.basetype == OIIO::TypeDesc::INT64;
}

void require_readable(const fs::path& path, const OIIO::ImageSpec& spec) {
  if (spec.deep) refuse_image(path, "is a deep image; only flat ones are compared");
  if (spec.depth > 1) refuse_image(path, "is a volume; only flat images are compared");
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) refuse_image(path, "has no pixels");
  if (std::int64_t{spec.width} * spec.height > kMostValues / spec.nchannels) {
    refuse_image(path, "says that it is " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                           " with " + std::to_string(spec.nchannels) + " channels, which is too large");
  }
  for (int c = 0; c < spec.nchannels; ++c) {
    if (is_wide_integer(spec.channelformat(c))) {
      refuse_image(path, "channel " + std::string(spec.channel_name(c)) +
                             " holds 32-bit integers; only floats, halves and 8- or 16-bit integers are "
                             "compared");
    }
  }
}

// "PART.CHANNEL" in files of several parts.
std::string plane_name(const OIIO::ImageSpec& spec, int channel, const std::string& part) {
  const std::string name(spec.channel_name(channel));
  return part.empty() || name.rfind(part + ".", 0) == 0 ? name : part + "." + name;
}

void add_part(const fs::path& path, OIIO::ImageInput& input, int number, bool several, ImagePlanes& image) {
  const OIIO::ImageSpec& spec = input.spec();
  require_readable(path, spec);
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<float>& values = image.storage.emplace_back(static_cast<std::size_t>(spec.width) *
                                                          static_cast<std::size_t>(spec.height) * channels);
  if (!input.read_image(number, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data())) {
    refuse_image(path, "cannot be decoded: " + reason(input.geterror()));
  }
  std::string part;
  if (several) {
    part = spec.get_string_attribute("oiio:subimagename", std::to_string(number));
  }
  for (int c = 0; c < spec.nchannels; ++c) {
    const std::string name = plane_name(spec, c, part);
    for (const Plane& plane : image.planes) {
      if (plane.name == name) refuse_image(path, "has two channels named " + name);
    }
    image.planes.push_back({name,
                            {values.data() + c, channels, spec.width, spec.height},
                            spec.x - spec.full_x,
                            spec.y - spec.full_y,
                            !spec.channelformat(c).is_floating_point()});
  }
}

}  // namespace

ImagePlanes read_planes(const fs::path& path) {
  const auto input = open_image(path);
  const bool several = input->seek_subimage(1, 0);
  ImagePlanes image;
  for (int number = 0; number < kMostParts && input->seek_subimage(number, 0); ++number) {
    add_part(path, *input, number, several, image);
    stop_if_interrupted();
  }
  // Looking for a part behind the last one leaves a message that OpenImageIO would print.
  (void)input->geterror();
  return image;
}

}  // namespace caustics::app
