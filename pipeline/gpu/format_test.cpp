#include "pipeline/gpu/format.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("half: every half survives the way to float and back") {
  int wrong = 0;
  for (unsigned h = 0; h < 0x10000u; ++h) {
    const auto half = static_cast<std::uint16_t>(h);
    const bool nan = (h & 0x7c00u) == 0x7c00u && (h & 0x3ffu) != 0;
    const float value = float_from_half(half);
    wrong += nan ? !std::isnan(value) : half_from_float(value) != half;
  }
  CHECK(wrong == 0);
}

TEST_CASE("half: a float is stored as on the way to a half and back, whatever its bits") {
  std::uint32_t wrong = 0;
  for (std::uint64_t bits = 0; bits < 0x100000000ull; bits += 1021) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    const float there_and_back = float_from_half(half_from_float(value));
    wrong += std::bit_cast<std::uint32_t>(stored_value(Format::RGBA16F, value)) !=
             std::bit_cast<std::uint32_t>(there_and_back);
  }
  CHECK(wrong == 0);
}

TEST_CASE("half: ties go to the even neighbour") {
  // Halves near 1 are 2^-10 apart: 1 + 2^-11 lies between 1 (even) and 1 + 2^-10 (odd).
  CHECK(stored_value(Format::RGBA16F, 1.0f + 0x1p-11f) == 1.0f);
  CHECK(stored_value(Format::RGBA16F, 1.0f + 0x3p-11f) == 1.0f + 0x1p-9f);
  CHECK(stored_value(Format::RGBA16F, 1.0f + 0x1p-11f + 0x1p-20f) == 1.0f + 0x1p-10f);
}

TEST_CASE("half: the smallest subnormal, half of it, and a little more than half of it") {
  CHECK(stored_value(Format::RGBA16F, 0x1p-24f) == 0x1p-24f);
  CHECK(stored_value(Format::RGBA16F, 0x1p-25f) == 0.0f);
  CHECK(stored_value(Format::RGBA16F, 0x1.8p-25f) == 0x1p-24f);
}

TEST_CASE("half: what is too large stops at 65504, infinity stays") {
  CHECK(stored_value(Format::RGBA16F, 65504.0f) == 65504.0f);
  CHECK(stored_value(Format::RGBA16F, 65519.0f) == 65504.0f);
  CHECK(stored_value(Format::RGBA16F, 1e30f) == 65504.0f);
  CHECK(stored_value(Format::RGBA16F, -1e30f) == -65504.0f);
  CHECK(std::isinf(stored_value(Format::RGBA16F, std::numeric_limits<float>::infinity())));
}

TEST_CASE("unorm8: 0 to 1 in 255 steps, clamped, ties to even, NaN to 0") {
  CHECK(unorm8_from_float(0.0f) == 0);
  CHECK(unorm8_from_float(1.0f) == 255);
  CHECK(unorm8_from_float(-3.0f) == 0);
  CHECK(unorm8_from_float(7.0f) == 255);
  CHECK(unorm8_from_float(std::nanf("")) == 0);
  CHECK(unorm8_from_float(0.5f) == 128);  // 127.5 lies between 127 and 128
  CHECK(unorm8_from_float(2.5f / 255.0f) == 2);
  for (int i = 0; i < 256; ++i)
    CHECK(unorm8_from_float(stored_value(Format::RGBA8, static_cast<float>(i) / 255.0f)) == i);
}
