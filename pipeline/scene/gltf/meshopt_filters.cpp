#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "pipeline/scene/gltf/compressed.hpp"

namespace caustics::gltf {

namespace {

template <typename T>
T stored_at(const Bytes& data, std::size_t byte) {
  T value;
  std::memcpy(&value, data.data() + byte, sizeof value);
  return value;
}

template <typename T>
void store_at(Bytes& data, std::size_t byte, T value) {
  std::memcpy(data.data() + byte, &value, sizeof value);
}

// The nearest integer of a normalised one, halves away from 0.
template <typename T>
T normalised(double value) {
  constexpr double kMost = (1u << (8 * sizeof(T) - 1)) - 1;
  const double scaled = std::clamp(value, -1.0, 1.0) * kMost;
  return static_cast<T>(scaled + (scaled >= 0 ? 0.5 : -0.5));
}

// Unit vectors; the third component is what stands for 1.
template <typename T>
void decode_octahedral_of(Bytes& data) {
  for (std::size_t at = 0; at + 4 * sizeof(T) <= data.size(); at += 4 * sizeof(T)) {
    double x = stored_at<T>(data, at), y = stored_at<T>(data, at + sizeof(T));
    const double one = stored_at<T>(data, at + 2 * sizeof(T));
    const double z = one - std::abs(x) - std::abs(y), over = std::min(z, 0.0);
    x += x >= 0 ? over : -over;
    y += y >= 0 ? over : -over;
    const double length = std::sqrt(x * x + y * y + z * z), scale = length > 0 ? 1 / length : 0;
    store_at(data, at, normalised<T>(x * scale));
    store_at(data, at + sizeof(T), normalised<T>(y * scale));
    store_at(data, at + 2 * sizeof(T), normalised<T>(z * scale));
  }
}

}  // namespace

void decode_octahedral(Bytes& data, std::size_t stride) {
  stride == 4 ? decode_octahedral_of<std::int8_t>(data) : decode_octahedral_of<std::int16_t>(data);
}

// The largest component is left out; the last two bits say which.
void decode_quaternion(Bytes& data) {
  constexpr double kRootHalf = 0.70710678118654752440;
  for (std::size_t at = 0; at + 8 <= data.size(); at += 8) {
    const auto last = stored_at<std::int16_t>(data, at + 6);
    const double scale = kRootHalf / (last | 3);
    std::array<double, 4> parts{};
    double square = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      parts[i] = stored_at<std::int16_t>(data, at + 2 * i) * scale;
      square -= parts[i] * parts[i];
    }
    parts[3] = std::sqrt(std::max(square, 0.0));
    const auto largest = static_cast<std::size_t>(last & 3);
    for (std::size_t i = 0; i < 4; ++i)
      store_at(data, at + 2 * ((largest + 1 + i) % 4), normalised<std::int16_t>(parts[i]));
  }
}

// Floats as 24 bits of integer times 2 to the power of 8 bits, each exact.
void decode_exponential(Bytes& data) {
  for (std::size_t at = 0; at + 4 <= data.size(); at += 4) {
    const auto bits = stored_at<std::uint32_t>(data, at);
    const int exponent = static_cast<std::int32_t>(bits) >> 24;
    const int mantissa = static_cast<std::int32_t>(bits << 8) >> 8;
    // The specification's exponents are -100..100.
    const auto power = static_cast<std::uint32_t>(std::clamp(exponent, -100, 100) + 127) << 23;
    float scale;
    std::memcpy(&scale, &power, sizeof scale);
    store_at(data, at, scale * static_cast<float>(mantissa));
  }
}

}  // namespace caustics::gltf
