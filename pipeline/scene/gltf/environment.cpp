#include "pipeline/scene/gltf/container.hpp"
#include "pipeline/scene/gltf/image_file.hpp"
#include "pipeline/scene/gltf/load_environment.hpp"

namespace caustics {

namespace {

float usable(float value) { return value - value == 0.0f && value > 0.0f ? value : 0.0f; }

Image to_image(const Pixels& pixels) {
  Image image(Format::RGBA32F, pixels.width, pixels.height);
  const auto channels = static_cast<std::size_t>(pixels.channels);
  const auto width = static_cast<std::size_t>(pixels.width);
  float* out = image.values.data();
  for (int y = pixels.height - 1; y >= 0; --y) {  // row 0 is the bottom one
    const float* texel = pixels.floats.data() + static_cast<std::size_t>(y) * width * channels;
    for (std::size_t x = 0; x < width; ++x, texel += channels) {
      for (std::size_t c = 0; c < 3; ++c) *out++ = usable(texel[channels < 3 ? 0 : c]);
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
                          problem)) {
    context.fail("", problem, "use another image");
  }
  Environment environment;
  environment.image = to_image(pixels);
  return environment;
}

}  // namespace caustics
