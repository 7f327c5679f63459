#include "pipeline/image_io/png_and_jpeg.hpp"

#include <png.h>
#include <turbojpeg.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <memory>
#include <type_traits>
#include <vector>

namespace caustics {

namespace {

// libpng ends a function that fails by longjmp: nothing with a destructor is made between setjmp and it.
struct PngReader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::span<const std::uint8_t> left;
  std::string problem;

  explicit PngReader(std::span<const std::uint8_t> bytes) : left(bytes) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, [](png_structp, png_const_charp) {});
    if (png) info = png_create_info_struct(png);
    if (info) png_set_read_fn(png, this, read);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

  [[noreturn]] static void fail(png_structp png, png_const_charp message) {
    static_cast<PngReader*>(png_get_error_ptr(png))->problem = message;
    png_longjmp(png, 1);
  }
  static void read(png_structp png, png_bytep out, std::size_t count) {
    auto& left = static_cast<PngReader*>(png_get_io_ptr(png))->left;
    if (count > left.size()) png_error(png, "it ends too early");
    std::copy_n(left.begin(), count, out);
    left = left.subspan(count);
  }

  bool read_header() {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_read_info(png, info);
    png_set_expand(png);
    if (std::endian::native == std::endian::little) png_set_swap(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
  }
  bool read_rows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_read_image(png, rows);
    return true;
  }
};

struct CloseTurbo {
  void operator()(void* turbo) const { tjDestroy(turbo); }
};
using Turbo = std::unique_ptr<std::remove_pointer_t<tjhandle>, CloseTurbo>;

struct JpegHeader {
  int width = 0, height = 0, subsampling = 0, colors = TJCS_CMYK;
};

bool read_header(const Turbo& turbo, std::span<const std::uint8_t> bytes, JpegHeader& header) {
  return turbo && tjDecompressHeader3(turbo.get(), bytes.data(), bytes.size(), &header.width, &header.height,
                                      &header.subsampling, &header.colors) == 0;
}

std::string cannot(const std::string& why) { return "cannot be decoded: " + why; }

}  // namespace

std::string decode_png(std::span<const std::uint8_t> bytes, Pixels& pixels) {
  PngReader reader(bytes);
  if (!reader.info) return cannot("there is no memory for it");
  if (!reader.read_header()) return cannot(reader.problem);
  const auto width = png_get_image_width(reader.png, reader.info);
  const auto height = png_get_image_height(reader.png, reader.info);
  const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
  const bool wide = png_get_bit_depth(reader.png, reader.info) == 16;
  if (wide) pixels.integers.resize(row_bytes * height / 2);
  if (!wide) pixels.bytes.resize(row_bytes * height);
  auto* stored = wide ? reinterpret_cast<png_bytep>(pixels.integers.data()) : pixels.bytes.data();
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < height; ++y) rows[y] = stored + y * row_bytes;
  if (!reader.read_rows(rows.data())) return cannot(reader.problem);
  pixels.width = static_cast<int>(width);
  pixels.height = static_cast<int>(height);
  pixels.channels = png_get_channels(reader.png, reader.info);
  pixels.largest = wide ? 65535 : 255;
  return "";
}

bool is_usual_jpeg(std::span<const std::uint8_t> bytes) {
  JpegHeader header;
  return read_header(Turbo(tjInitDecompress()), bytes, header) && header.colors != TJCS_CMYK &&
         header.colors != TJCS_YCCK;
}

std::string decode_jpeg(std::span<const std::uint8_t> bytes, Pixels& pixels) {
  const Turbo turbo(tjInitDecompress());
  JpegHeader header;
  if (!read_header(turbo, bytes, header)) return cannot(tjGetErrorStr2(turbo.get()));
  if (header.width < 1 || header.height < 1) return cannot("it ends in its head");
  pixels.width = header.width;
  pixels.height = header.height;
  pixels.channels = header.colors == TJCS_GRAY ? 1 : 3;
  pixels.bytes.resize(static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height) *
                      static_cast<std::size_t>(pixels.channels));
  const int format = pixels.channels == 1 ? TJPF_GRAY : TJPF_RGB;
  if (tjDecompress2(turbo.get(), bytes.data(), bytes.size(), pixels.bytes.data(), header.width, 0,
                    header.height, format, TJFLAG_ACCURATEDCT) != 0 &&
      tjGetErrorCode(turbo.get()) == TJERR_FATAL)
    return cannot(tjGetErrorStr2(turbo.get()));
  return "";
}

}  // namespace caustics
