#include "pipeline/scene/gltf/image_file.hpp"

#include "pipeline/image_io/png_and_jpeg.hpp"

namespace caustics::gltf {

namespace {

constexpr int kMostScans = 200;  // progressive encoders write about ten

const char* format_name(ImageKind kind) {
  switch (kind) {
    case ImageKind::Jpeg:
      return "jpeg";
    case ImageKind::Webp:
      return "webp";
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

}  // namespace

bool decode_image(std::span<const std::uint8_t> bytes, ImageKind kind, int max_side, std::uint64_t max_pixels,
                  Pixels& pixels, std::string& problem,
                  const std::function<void(std::uint64_t bytes)>& before) {
  ImageHeader header = sniff_image(bytes);
  problem = header.problem;
  if (header.kind != kind && problem.empty()) problem = "is of another format";
  if (problem.empty() && kind != ImageKind::Exr) {
    problem = size_problem(header.width, header.height, max_side, max_pixels);
  }
  if (problem.empty() && header.scans > kMostScans) {
    problem = "is a JPEG of " + std::to_string(header.scans) + " scans";
  }
  if (!problem.empty()) return false;
  if (before && kind != ImageKind::Exr) before(header.decoding_bytes());
  if (kind == ImageKind::Png) {
    problem = decode_png(bytes, pixels);
    return problem.empty();
  }
  if (kind == ImageKind::Jpeg && is_usual_jpeg(bytes)) {
    problem = decode_jpeg(bytes, pixels);
    return problem.empty();
  }
  const bool floats = kind == ImageKind::Hdr || kind == ImageKind::Exr;
  // The size is checked again: this is what will be allocated.
  problem = image_io().decode({bytes, format_name(kind), floats,
                               [&](std::int64_t width, std::int64_t height, int channels) {
                                 std::string why = size_problem(width, height, max_side, max_pixels);
                                 if (!why.empty()) return why;
                                 header.width = static_cast<int>(width);
                                 header.height = static_cast<int>(height);
                                 header.channels = channels;
                                 if (before) before(header.decoding_bytes());
                                 return why;
                               }},
                              pixels);
  return problem.empty();
}

}  // namespace caustics::gltf
