// Texel formats of textures and render targets, and the conversions that storing a value implies.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace caustics {

// What one texel holds. Colour formats are linear; RGBA8 is unsigned-normalised (0..1 in 255 steps).
enum class Format : std::uint8_t { R32F, RG32F, RGBA32F, RGBA16F, RGBA8, Depth32F };

inline constexpr Format kAllFormats[] = {Format::R32F,    Format::RG32F, Format::RGBA32F,
                                         Format::RGBA16F, Format::RGBA8, Format::Depth32F};

// Number of channels, 1 to 4.
constexpr int channel_count(Format format) {
  switch (format) {
    case Format::R32F:
    case Format::Depth32F:
      return 1;
    case Format::RG32F:
      return 2;
    case Format::RGBA32F:
    case Format::RGBA16F:
    case Format::RGBA8:
      return 4;
  }
  return 0;
}
// Bytes of one texel as stored on a GPU.
std::size_t bytes_per_texel(Format format);
// The name as it is written in this enumeration, for messages and manifests.
std::string_view format_name(Format format);
bool is_depth(Format format);

// IEEE 754 binary16, round to nearest even. A finite value beyond the range becomes +-65504, which is
// what llvmpipe's blending stores (measured); infinities and NaN stay what they are.
std::uint16_t half_from_float(float value);
float float_from_half(std::uint16_t half);

// Unsigned-normalised 8 bits (OpenGL 4.5 core, 2.3.5.1): clamped to 0..1, times 255, nearest even;
// NaN becomes 0.
std::uint8_t unorm8_from_float(float value);

// The value that a texel of this format holds after `value` was stored in one of its channels.
float stored_value(Format format, float value);

}  // namespace caustics
