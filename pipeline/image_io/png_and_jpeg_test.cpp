#include "pipeline/image_io/png_and_jpeg.hpp"

#include <png.h>
#include <turbojpeg.h>

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int kWidth = 37, kHeight = 23;

std::uint8_t noise(std::size_t i) { return static_cast<std::uint8_t>(i * 2654435761u >> 13); }

struct Kind {
  int colors, depth, interlaced;
};

// A PNG of noise: of palettes and single colours some are transparent.
Bytes png_of(const Kind& kind) {
  Bytes bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp to, png_bytep from, std::size_t count) {
        auto& out = *static_cast<Bytes*>(png_get_io_ptr(to));
        out.insert(out.end(), from, from + count);
      },
      [](png_structp) {});
  png_set_IHDR(png, info, kWidth, kHeight, kind.depth, kind.colors, kind.interlaced,
               PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
  png_color palette[16];
  png_byte alphas[16];
  for (std::size_t i = 0; i < 16; ++i) {
    palette[i] = {noise(3 * i), noise(3 * i + 1), noise(3 * i + 2)};
    alphas[i] = noise(i + 7);
  }
  png_color_16 single{.index = 0, .red = 1, .green = 1, .blue = 1, .gray = 1};
  if (kind.colors == PNG_COLOR_TYPE_PALETTE) {
    png_set_PLTE(png, info, palette, 1 << kind.depth);
    png_set_tRNS(png, info, alphas, 1 << kind.depth, nullptr);
  } else if (kind.colors == PNG_COLOR_TYPE_GRAY) {
    png_set_tRNS(png, info, nullptr, 0, &single);
  }
  png_write_info(png, info);
  Bytes texels(png_get_rowbytes(png, info) * kHeight);
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = noise(i);
  std::vector<png_bytep> rows;
  for (std::size_t y = 0; y < kHeight; ++y) rows.push_back(texels.data() + y * png_get_rowbytes(png, info));
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

Bytes jpeg_of(const std::vector<std::string>& channels) {
  ImageToEncode image{
      .format = ImageFormat::Jpeg, .width = kWidth, .height = kHeight, .channels = channels, .row = {}};
  image.row = [&](int row, float* values) {
    for (std::size_t i = 0; i < kWidth * channels.size(); ++i)
      values[i] = static_cast<float>(noise(i + static_cast<std::size_t>(row) * 97)) / 255.0f;
  };
  Bytes bytes;
  REQUIRE(image_io().encode(image, bytes) == "");
  return bytes;
}

Pixels by_openimageio(const Bytes& bytes, const char* format) {
  Pixels pixels;
  REQUIRE(image_io().decode({bytes, format, false, [](auto, auto, int) { return ""; }}, pixels) == "");
  return pixels;
}

void check_same(const Pixels& a, const Pixels& b) {
  CHECK(a.width == b.width);
  CHECK(a.height == b.height);
  CHECK(a.channels == b.channels);
  CHECK(a.largest == b.largest);
  CHECK(a.bytes == b.bytes);
  CHECK(a.integers == b.integers);
}

}  // namespace

TEST_CASE("png and jpeg: every kind of PNG has the texels that OpenImageIO reads") {
  const Kind kind = GENERATE(Kind{PNG_COLOR_TYPE_RGB, 8, 0}, Kind{PNG_COLOR_TYPE_RGB_ALPHA, 16, 1},
                             Kind{PNG_COLOR_TYPE_GRAY, 2, 0}, Kind{PNG_COLOR_TYPE_GRAY_ALPHA, 8, 1},
                             Kind{PNG_COLOR_TYPE_PALETTE, 4, 0}, Kind{PNG_COLOR_TYPE_GRAY, 16, 0});
  CAPTURE(kind.colors, kind.depth);
  const Bytes bytes = png_of(kind);
  Pixels pixels;
  CHECK(decode_png(bytes, pixels) == "");
  check_same(pixels, by_openimageio(bytes, "png"));
}

TEST_CASE("png and jpeg: a JPEG of colours or greys has the texels that OpenImageIO reads") {
  const Bytes bytes =
      jpeg_of(GENERATE(std::vector<std::string>{"Y"}, std::vector<std::string>{"R", "G", "B"}));
  CHECK(is_usual_jpeg(bytes));
  Pixels pixels;
  CHECK(decode_jpeg(bytes, pixels) == "");
  check_same(pixels, by_openimageio(bytes, "jpeg"));
}

TEST_CASE("png and jpeg: a JPEG of four inks is not a usual one") {
  const Bytes inks(4 * kWidth * kHeight, 128);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const tjhandle turbo = tjInitCompress();
  REQUIRE(tjCompress2(turbo, inks.data(), kWidth, 0, kHeight, TJPF_CMYK, &bytes, &size, TJSAMP_444, 90, 0) ==
          0);
  CHECK_FALSE(is_usual_jpeg({bytes, size}));
  tjFree(bytes);
  tjDestroy(turbo);
}

TEST_CASE("png and jpeg: damaged files are refused in a few words") {
  Pixels pixels;
  Bytes png = png_of({PNG_COLOR_TYPE_RGB, 8, 0});
  png[50] ^= 0xFFu;
  CHECK(decode_png(png, pixels).find("cannot be decoded: ") == 0);
  CHECK(decode_png(Bytes(png.begin(), png.begin() + 40), pixels).find("cannot be decoded: ") == 0);
  const Bytes jpeg = jpeg_of({"R", "G", "B"});
  const Bytes cut(jpeg.begin(), jpeg.begin() + 30);
  CHECK_FALSE(is_usual_jpeg(cut));
  CHECK(decode_jpeg(cut, pixels).find("cannot be decoded: ") == 0);
}
