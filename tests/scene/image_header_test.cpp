// What an image's first bytes say of the memory that decoding it takes.
#include "pipeline/scene/gltf/image_file.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, const std::string& text) { bytes.insert(bytes.end(), text.begin(), text.end()); }

void append(Bytes& bytes, unsigned value, int count) {
  for (int i = count - 1; i >= 0; --i) bytes.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

// Up to the starts of its scans, which hold nothing.
Bytes jpeg(unsigned width, unsigned height, unsigned channels, int scans) {
  Bytes bytes = {0xFF, 0xD8, 0xFF, 0xC2};
  append(bytes, 8 + 3 * channels, 2);
  append(bytes, 8, 1);
  append(bytes, height, 2);
  append(bytes, width, 2);
  append(bytes, channels, 1);
  bytes.resize(bytes.size() + 3 * channels);
  for (int i = 0; i < scans; ++i) append(bytes, 0xFFDA, 2);
  return bytes;
}

// A header and an end, with no image between.
Bytes png(unsigned width, unsigned height, unsigned bits, unsigned color_type) {
  Bytes bytes;
  append(bytes, "\x89PNG\r\n\x1a\n");
  append(bytes, 13, 4);
  append(bytes, "IHDR");
  append(bytes, width, 4);
  append(bytes, height, 4);
  append(bytes, bits, 1);
  append(bytes, color_type, 1);
  append(bytes, 0, 3);
  append(bytes, 0, 4);
  append(bytes, 0, 4);
  append(bytes, "IEND");
  append(bytes, 0, 4);
  return bytes;
}

std::uint64_t decoding_bytes(const Bytes& bytes) {
  const gltf::ImageHeader header = gltf::sniff_image(bytes);
  CHECK(header.problem == "");
  return header.decoding_bytes();
}

}  // namespace

TEST_CASE("image header: a JPEG of several scans takes the room of its coefficients beside its values") {
  for (const unsigned width : {1u, 37u, 300u})
    for (const unsigned height : {1u, 65u})
      for (const unsigned channels : {1u, 3u, 4u}) {
        INFO(width << " x " << height << ", " << channels << " channels");
        const std::uint64_t values = std::uint64_t{1} * width * height * channels;
        CHECK(decoding_bytes(jpeg(width, height, channels, 1)) == values);
        for (const int scans : {2, 3, 10})
          CHECK(decoding_bytes(jpeg(width, height, channels, scans)) == 3 * values);
      }
}

TEST_CASE("image header: a PNG takes its channels, of a palette four, in one byte or two") {
  struct Kind {
    unsigned color_type;
    std::uint64_t channels;
  };
  for (const Kind& kind : {Kind{0, 1}, Kind{2, 3}, Kind{3, 4}, Kind{4, 2}, Kind{6, 4}}) {
    INFO("colour type " << kind.color_type);
    for (const unsigned bits : {1u, 8u})
      CHECK(decoding_bytes(png(7, 5, bits, kind.color_type)) == 35 * kind.channels);
    CHECK(decoding_bytes(png(7, 5, 16, kind.color_type)) == 35 * 2 * kind.channels);
  }
}

TEST_CASE("image header: a Radiance image takes four floats a texel, a WebP four bytes twice") {
  Bytes radiance;
  append(radiance, "#?RADIANCE\n\n-Y 5 +X 7\n");
  CHECK(decoding_bytes(radiance) == 7 * 5 * 4 * 4);
  // Sides less one, the lower byte first.
  Bytes webp;
  append(webp, "RIFF");
  append(webp, 0x16000000, 4);
  append(webp, "WEBPVP8X");
  append(webp, 0x0A000000, 4);
  append(webp, 0, 4);
  append(webp, 0x060000, 3);
  append(webp, 0x040000, 3);
  CHECK(decoding_bytes(webp) == 7 * 5 * 4 * 2);
}
