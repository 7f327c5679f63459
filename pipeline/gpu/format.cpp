#include "pipeline/gpu/format.hpp"

#include <bit>
#include <cmath>

namespace caustics {

std::size_t bytes_per_texel(Format format) {
  switch (format) {
    case Format::R32F:
    case Format::Depth32F:
    case Format::RGBA8:
      return 4;
    case Format::RG32F:
    case Format::RGBA16F:
      return 8;
    case Format::RGBA32F:
      return 16;
  }
  return 0;
}

std::string_view format_name(Format format) {
  switch (format) {
    case Format::R32F:
      return "R32F";
    case Format::RG32F:
      return "RG32F";
    case Format::RGBA32F:
      return "RGBA32F";
    case Format::RGBA16F:
      return "RGBA16F";
    case Format::RGBA8:
      return "RGBA8";
    case Format::Depth32F:
      return "Depth32F";
  }
  return "?";
}

bool is_depth(Format format) { return format == Format::Depth32F; }

std::uint16_t half_from_float(float value) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
  const auto sign = static_cast<std::uint16_t>((bits >> 16) & 0x8000u);
  const std::uint32_t magnitude = bits & 0x7fffffffu;
  if (magnitude > 0x7f800000u) return sign | 0x7e00u;
  if (magnitude == 0x7f800000u) return sign | 0x7c00u;
  if (magnitude >= 0x477ff000u) return sign | 0x7bffu;
  const int exponent = static_cast<int>(magnitude >> 23) - 127;
  if (exponent < -25) return sign;
  // Bits below the half's last place: 13 for normal numbers, more for subnormal ones.
  const int dropped = exponent >= -14 ? 13 : -1 - exponent;
  const std::uint32_t significand = (magnitude & 0x7fffffu) | 0x800000u;
  const std::uint32_t biased = exponent >= -14 ? static_cast<std::uint32_t>(exponent + 14) << 10 : 0u;
  const std::uint32_t kept = significand >> dropped;
  const std::uint32_t remainder = significand & ((1u << dropped) - 1u);
  const std::uint32_t half_way = 1u << (dropped - 1);
  const std::uint32_t up = remainder > half_way || (remainder == half_way && (kept & 1u)) ? 1u : 0u;
  return static_cast<std::uint16_t>(sign | (biased + kept + up));
}

float float_from_half(std::uint16_t half) {
  const std::uint32_t sign = static_cast<std::uint32_t>(half & 0x8000u) << 16;
  const std::uint32_t exponent = (half >> 10) & 0x1fu;
  const std::uint32_t fraction = half & 0x3ffu;
  if (exponent == 31u) return std::bit_cast<float>(sign | 0x7f800000u | (fraction << 13));
  if (exponent != 0u) return std::bit_cast<float>(sign | ((exponent + 112u) << 23) | (fraction << 13));
  const float magnitude = static_cast<float>(fraction) * 0x1p-24f;
  return sign ? -magnitude : magnitude;
}

namespace {

float nearest_half(float value) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(value), magnitude = bits & 0x7fffffffu;
  const bool is_normal = magnitude >= 0x38800000u && magnitude < 0x477ff000u;
  if (!is_normal) return float_from_half(half_from_float(value));
  // To the nearest multiple of the half's last place, ties to even; a carry moves on into the exponent.
  return std::bit_cast<float>((bits + 0xfffu + (bits >> 13 & 1u)) & ~0x1fffu);
}

}  // namespace

std::uint8_t unorm8_from_float(float value) {
  if (!(value > 0.0f)) return 0;
  if (value >= 1.0f) return 255;
  const float scaled = value * 255.0f;
  const float below = std::floor(scaled);
  const float fraction = scaled - below;
  int whole = static_cast<int>(below);
  if (fraction > 0.5f || (fraction == 0.5f && (whole & 1))) ++whole;
  return static_cast<std::uint8_t>(whole);
}

float stored_value(Format format, float value) {
  switch (format) {
    case Format::RGBA16F:
      return nearest_half(value);
    case Format::RGBA8:
      return static_cast<float>(unorm8_from_float(value)) / 255.0f;
    case Format::R32F:
    case Format::RG32F:
    case Format::RGBA32F:
    case Format::Depth32F:
      return value;
  }
  return value;
}

}  // namespace caustics
