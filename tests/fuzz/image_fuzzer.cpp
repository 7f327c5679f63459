// Any bytes as an image of a texture or an environment: a message, or as many texels as it says.
#include "pipeline/scene/gltf/image_file.hpp"
#include "tests/fuzz/fuzzed_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace caustics;
  constexpr int kMostSide = 256;
  constexpr std::uint64_t kMostPixels = 1 << 14;
  const fuzz::ByteSpan bytes(data, size);
  const gltf::ImageHeader header = gltf::sniff_image(bytes);
  // Textures are PNG or JPEG; other formats are for environments, which are a person's own files.
  if (header.kind != gltf::ImageKind::Png && header.kind != gltf::ImageKind::Jpeg) return 0;
  Pixels pixels;
  std::string problem;
  if (!gltf::decode_image(bytes, header.kind, kMostSide, kMostPixels, pixels, problem)) {
    if (problem.empty()) fuzz::finding("a picture is refused without a reason");
    return 0;
  }
  const auto count = static_cast<std::uint64_t>(pixels.width) * static_cast<std::uint64_t>(pixels.height);
  if (pixels.width > kMostSide || pixels.height > kMostSide || count > kMostPixels)
    fuzz::finding("a picture is larger than its limit");
  if (pixels.integers.size() + pixels.bytes.size() != count * static_cast<std::uint64_t>(pixels.channels))
    fuzz::finding("a picture has another number of texels than its size says");
  return 0;
}
