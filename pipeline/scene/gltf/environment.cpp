#include <algorithm>

#include "pipeline/scene/gltf/container.hpp"
#include "pipeline/scene/gltf/image_file.hpp"
#include "pipeline/scene/gltf/load_environment.hpp"

namespace caustics {

namespace {

// Wider ones are averaged down: a picture has hardly more texels of them than this, and a lone 16k image
// would take 2 GiB.
constexpr int kMostColumns = 8192;

float usable(float value) { return value - value == 0.0f && value > 0.0f ? value : 0.0f; }

// The mean of a channel over `side` x `side` pixels from column x and row y on; less at the image's end.
float mean_of(const Pixels& pixels, int x, int y, int side, int channel) {
  const int right = std::min(x + side, pixels.width), end = std::min(y + side, pixels.height);
  double sum = 0.0;
  for (int row = y; row < end; ++row)
    for (int column = x; column < right; ++column) {
      const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels.width) +
                                static_cast<std::size_t>(column);
      sum += static_cast<double>(
          usable(pixels.floats[pixel * static_cast<std::size_t>(pixels.channels) +
                               static_cast<std::size_t>(pixels.channels < 3 ? 0 : channel)]));
    }
  return static_cast<float>(sum / (static_cast<double>(right - x) * (end - y)));
}

Image to_image(const Pixels& pixels) {
  int side = 1;  // of the pixels that become one texel
  while ((pixels.width + side - 1) / side > kMostColumns) side *= 2;
  Image image(Format::RGBA32F, (pixels.width + side - 1) / side, (pixels.height + side - 1) / side);
  float* out = image.values.data();
  for (int y = image.height() - 1; y >= 0; --y) {  // row 0 is the bottom one
    for (int x = 0; x < image.width(); ++x) {
      for (int c = 0; c < 3; ++c) *out++ = mean_of(pixels, x * side, y * side, side, c);
      *out++ = 1.0f;
    }
  }
  return image;
}

}  // namespace

Environment load_environment(const std::filesystem::path& path, const LoadOptions& options) {
  gltf::Context context(path, options);
  const gltf::Bytes bytes = gltf::read_file(context, path, "");
  const gltf::ImageHeader header = gltf::sniff_image(bytes);
  if (header.kind != gltf::ImageKind::Hdr && header.kind != gltf::ImageKind::Exr) {
    context.fail("", "is neither Radiance (.hdr) nor OpenEXR (.exr)",
                 "environments must hold linear light: convert the image");
  }
  Pixels pixels;
  std::string problem;
  if (!gltf::decode_image(bytes, header.kind, options.max_image_side, options.max_image_pixels, pixels,
                          problem, [&](std::uint64_t texels) {
                            // The environment has four floats a texel, and no more than kMostColumns columns.
                            context.need_memory(texels + texels / 3 * 4, "texels");
                          })) {
    context.fail("", problem, "use another image");
  }
  Environment environment;
  environment.image = to_image(pixels);
  return environment;
}

}  // namespace caustics
