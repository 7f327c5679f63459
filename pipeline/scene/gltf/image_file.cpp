#include "pipeline/scene/gltf/image_file.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace caustics::gltf {

namespace {

constexpr int kMostScans = 200;  // progressive encoders write about ten

const char* plugin_name(ImageKind kind) {
  switch (kind) {
    case ImageKind::Png:
      return "png";
    case ImageKind::Jpeg:
      return "jpeg";
    case ImageKind::Hdr:
      return "hdr";
    default:
      return "openexr";
  }
}

// Empty when a picture of this size may be decoded.
std::string size_problem(std::int64_t width, std::int64_t height, int max_side, std::uint64_t max_pixels) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (width <= 0 || height <= 0) return "has no pixels (" + size + ")";
  if (width > max_side || height > max_side) {
    return "is " + size + ", larger than " + std::to_string(max_side) + " pixels a side";
  }
  if (static_cast<std::uint64_t>(width * height) > max_pixels) {
    return "is " + size + ", more pixels than the " + std::to_string(max_pixels) + " left";
  }
  return "";
}

std::string message_of(OIIO::ImageInput& input) {
  const std::string message = input.geterror();
  return "cannot be decoded: " + (message.empty() ? "the data are damaged" : message);
}

// Reads all pixels in rows from the top.
bool read_pixels(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, bool floats, Pixels& pixels,
                 std::string& problem) {
  pixels.width = spec.width;
  pixels.height = spec.height;
  pixels.channels = spec.nchannels;
  const std::size_t count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                            static_cast<std::size_t>(spec.nchannels);
  bool good = false;
  if (floats) {
    pixels.floats.resize(count);
    good = input.read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, pixels.floats.data());
  } else if (spec.format == OIIO::TypeDesc::UINT16) {
    pixels.largest = 65535;
    pixels.integers.resize(count);
    good = input.read_image(0, 0, 0, -1, OIIO::TypeDesc::UINT16, pixels.integers.data());
  } else {
    // Read as the bytes they are, so that no conversion of the library touches them.
    std::vector<std::uint8_t> bytes(count);
    good = input.read_image(0, 0, 0, -1, OIIO::TypeDesc::UINT8, bytes.data());
    pixels.integers.assign(bytes.begin(), bytes.end());
  }
  if (!good) problem = message_of(input);
  return good;
}

}  // namespace

bool decode_image(std::span<const std::uint8_t> bytes, ImageKind kind, int max_side, std::uint64_t max_pixels,
                  Pixels& pixels, std::string& problem) {
  const ImageHeader header = sniff_image(bytes);
  problem = header.problem;
  if (header.kind != kind && problem.empty()) problem = "is of another format";
  if (problem.empty() && kind != ImageKind::Exr) {
    problem = size_problem(header.width, header.height, max_side, max_pixels);
  }
  if (problem.empty() && header.scans > kMostScans) {
    problem = "is a JPEG of " + std::to_string(header.scans) + " scans";
  }
  if (!problem.empty()) return false;
  const std::string plugin = plugin_name(kind);
  const auto input = OIIO::ImageInput::create(plugin);
  if (!input) {
    problem = "cannot be decoded: OpenImageIO lacks " + plugin + " (" + OIIO::geterror() + ")";
    return false;
  }
  OIIO::Filesystem::IOMemReader reader(const_cast<std::uint8_t*>(bytes.data()), bytes.size());
  OIIO::Filesystem::IOProxy* proxy = &reader;
  OIIO::ImageSpec config, spec;
  config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  config.attribute("oiio:UnassociatedAlpha", 1);  // glTF's alpha is not premultiplied
  if (!input->open("memory." + plugin, spec, config)) {
    problem = message_of(*input);
    return false;
  }
  // Checked again: this is what will be allocated.
  problem = size_problem(spec.width, spec.height, max_side, max_pixels);
  if (problem.empty() && (spec.nchannels < 1 || spec.nchannels > 64 || spec.depth > 1)) {
    problem = "has " + std::to_string(spec.nchannels) + " channels";
  }
  const bool floats = kind == ImageKind::Hdr || kind == ImageKind::Exr;
  return problem.empty() && read_pixels(*input, spec, floats, pixels, problem);
}

}  // namespace caustics::gltf
