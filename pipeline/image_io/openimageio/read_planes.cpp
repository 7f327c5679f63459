#include <OpenImageIO/imageio.h>

#include "pipeline/image_io/openimageio/module.hpp"

namespace caustics::openimageio {

namespace {

// A header may promise any size; more than this is not allocated on its word alone.
constexpr std::int64_t kMostValues = std::int64_t{1} << 32;
constexpr int kMostParts = 1024;

bool is_wide_integer(const OIIO::TypeDesc& type) {
  return type.basetype == OIIO::TypeDesc::UINT32 || type.basetype == OIIO::TypeDesc::INT32 ||
         type.basetype == OIIO::TypeDesc::UINT64 || type.basetype == OIIO::TypeDesc::INT64;
}

std::string unreadable(const OIIO::ImageSpec& spec) {
  if (spec.deep) return "is a deep image; only flat ones are compared";
  if (spec.depth > 1) return "is a volume; only flat images are compared";
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) return "has no pixels";
  if (std::int64_t{spec.width} * spec.height > kMostValues / spec.nchannels) {
    return "says that it is " + std::to_string(spec.width) + "x" + std::to_string(spec.height) + " with " +
           std::to_string(spec.nchannels) + " channels, which is too large";
  }
  for (int c = 0; c < spec.nchannels; ++c) {
    if (is_wide_integer(spec.channelformat(c))) {
      return "channel " + std::string(spec.channel_name(c)) +
             " holds 32-bit integers; only floats, halves and 8- or 16-bit integers are compared";
    }
  }
  return "";
}

// "PART.CHANNEL" in files of several parts.
std::string plane_name(const OIIO::ImageSpec& spec, int channel, const std::string& part) {
  const std::string name(spec.channel_name(channel));
  return part.empty() || name.rfind(part + ".", 0) == 0 ? name : part + "." + name;
}

std::string add_part(OIIO::ImageInput& input, int number, bool several, ImagePlanes& image) {
  const OIIO::ImageSpec& spec = input.spec();
  if (std::string why = unreadable(spec); !why.empty()) return why;
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<float>& values = image.storage.emplace_back(static_cast<std::size_t>(spec.width) *
                                                          static_cast<std::size_t>(spec.height) * channels);
  if (!input.read_image(number, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data())) {
    return "cannot be decoded: " + reason(input.geterror());
  }
  std::string part;
  if (several) part = spec.get_string_attribute("oiio:subimagename", std::to_string(number));
  for (int c = 0; c < spec.nchannels; ++c) {
    const std::string name = plane_name(spec, c, part);
    for (const Plane& plane : image.planes) {
      if (plane.name == name) return "has two channels named " + name;
    }
    image.planes.push_back({name,
                            {values.data() + c, channels, spec.width, spec.height},
                            spec.x - spec.full_x,
                            spec.y - spec.full_y,
                            !spec.channelformat(c).is_floating_point()});
  }
  return "";
}

}  // namespace

std::string read_planes(const std::filesystem::path& path, const std::function<void()>& next_part,
                        ImagePlanes& planes) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) return "is no image that can be read: " + reason(OIIO::geterror());
  const bool several = input->seek_subimage(1, 0);
  for (int number = 0; number < kMostParts && input->seek_subimage(number, 0); ++number) {
    if (std::string why = add_part(*input, number, several, planes); !why.empty()) return why;
    next_part();
  }
  // Looking for a part behind the last one leaves a message that OpenImageIO would print.
  (void)input->geterror();
  return "";
}

bool read_size(const std::filesystem::path& path, int& width, int& height) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) {
    OIIO::geterror();  // fetched, so that nobody else finds it
    return false;
  }
  width = input->spec().width;
  height = input->spec().height;
  return true;
}

}  // namespace caustics::openimageio
