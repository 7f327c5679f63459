#include "pipeline/gpu/difference.hpp"

#include <cmath>
#include <limits>

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

Image row(const std::vector<float>& values) {
  Image image(Format::R32F, static_cast<int>(values.size()), 1);
  image.values = values;
  return image;
}

ValueDifference compare(const std::vector<float>& a, const std::vector<float>& b,
                        const Tolerance& tolerance = {}) {
  return difference(row(a), row(b), tolerance).all;
}

}  // namespace

TEST_CASE("difference: ULPs count the floats between two values") {
  CHECK(ulps_between(1.0f, 1.0f) == 0);
  CHECK(ulps_between(1.0f, std::nextafter(1.0f, 2.0f)) == 1);
  CHECK(ulps_between(1.0f, 2.0f) == 1u << 23);  // 23 bits of mantissa between powers of two
  CHECK(ulps_between(0.0f, -0.0f) == 0);
  const float smallest = std::numeric_limits<float>::denorm_min();
  CHECK(ulps_between(-smallest, smallest) == 2);
  CHECK(ulps_between(std::numeric_limits<float>::max(), kInfinity) == 1);
  // Two times the bits of the largest float, 0x7f7fffff: no overflow.
  CHECK(ulps_between(std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max()) == 0xfefffffeu);
}

TEST_CASE("difference: equal values, signed zeros, like infinities and like NaN do not differ") {
  const ValueDifference d = compare({0.0f, 3.0f, kInfinity, kNaN}, {-0.0f, 3.0f, kInfinity, -kNaN});
  CHECK(d.values == 4);
  CHECK(d.differing == 0);
  CHECK(d.beyond_tolerance == 0);
  CHECK(!d.first);
  CHECK(d.absolute.largest == 0.0);
  // The common NaN is named all the same.
  CHECK(d.nan_both == 1);
  REQUIRE(d.worst);
  CHECK(d.worst->x == 3);
}

TEST_CASE("difference: measures of one changed value among four") {
  // |2 - 2.5| = 0.5, of 2.5 it is 0.2; from 2 to 2.5 it is a quarter of an octave, 2^21 floats.
  const ValueDifference d = compare({1.0f, 2.0f, 0.0f, 4.0f}, {1.0f, 2.5f, 0.0f, 4.0f});
  CHECK(d.differing == 1);
  CHECK(d.absolute.largest == 0.5);
  CHECK(d.absolute.mean == 0.125);
  CHECK(d.relative.largest == 0.2);
  CHECK(d.ulps.largest == static_cast<double>(1 << 21));
  REQUIRE(d.worst);
  CHECK(d.worst->x == 1);
  CHECK(d.worst->a == 2.0f);
  CHECK(d.worst->b == 2.5f);
}

TEST_CASE("difference: the worst is the largest, the first is the first") {
  const ValueDifference d = compare({1.0f, 10.0f, 5.0f, 10.0f}, {1.5f, 13.0f, 5.0f, 13.0f});
  REQUIRE(d.first);
  REQUIRE(d.worst);
  CHECK(d.first->x == 0);
  CHECK(d.worst->x == 1);
}

TEST_CASE("difference: the 99.9th percentile leaves out one in a thousand") {
  std::vector<float> a(2000, 1.0f), b = a;
  b[7] = 9.0f;
  b[8] = 5.0f;
  // The 1998th of 2000 values in order: both changed ones lie above it.
  CHECK(compare(a, b).absolute.p999 == 0.0);
  b[9] = 3.0f;
  CHECK(compare(a, b).absolute.p999 == 2.0);
  CHECK(compare(a, b).absolute.largest == 8.0);
  // Of fewer than 1000 values it is the largest.
  CHECK(compare({0.0f, 1.0f}, {0.0f, 2.0f}).absolute.p999 == 1.0);
}

TEST_CASE("difference: either bound of the tolerance suffices") {
  const std::vector<float> a = {0.0f, 100.0f}, b = {0.125f, 101.0f};
  CHECK(compare(a, b).beyond_tolerance == 2);
  CHECK(compare(a, b, {0.125, 0.0}).beyond_tolerance == 1);
  CHECK(compare(a, b, {0.0, 0.01}).beyond_tolerance == 1);
  CHECK(compare(a, b, {0.125, 0.01}).beyond_tolerance == 0);
  CHECK(compare(a, b, {0.125, 0.01}).differing == 2);
}

TEST_CASE("difference: no tolerance lets a NaN or an infinity of one image pass") {
  const Tolerance any{1e300, 1e300};
  const ValueDifference d =
      compare({kNaN, 1.0f, kInfinity, kInfinity, 5.0f}, {1.0f, kNaN, 1.0f, -kInfinity, 5.5f}, any);
  CHECK(d.differing == 5);
  CHECK(d.beyond_tolerance == 4);
  CHECK(d.nan_only_a == 1);
  CHECK(d.nan_only_b == 1);
  CHECK(d.nan_both == 0);
  CHECK(d.infinite == 2);
  CHECK(d.has_nan());
  // The numbers are those of the finite pair.
  CHECK(d.absolute.largest == 0.5);
  CHECK(d.absolute.mean == 0.5);
  REQUIRE(d.worst);
  CHECK(d.worst->x == 0);
}

TEST_CASE("difference: images of another format or size are not compared texel by texel") {
  CHECK(!difference(Image(Format::R32F, 2, 1), Image(Format::R32F, 1, 2)).same_shape);
  CHECK(!difference(Image(Format::RGBA32F, 1, 1), Image(Format::RGBA16F, 1, 1)).same_shape);
}

TEST_CASE("difference: texels are counted once whatever number of channels differ") {
  Image a(Format::RG32F, 2, 2), b(Format::RG32F, 2, 2);
  b.at(1, 0, 1) = 1.0f;                        // only in B: a coverage mismatch
  a.at(0, 1, 0) = 1.0f, b.at(0, 1, 0) = 2.0f;  // in both
  a.at(0, 1, 1) = 1.0f, b.at(0, 1, 1) = 2.0f;
  const ImageDifference d = difference(a, b);
  REQUIRE(d.same_shape);
  CHECK(d.texels == 4);
  CHECK(d.differing_texels == 2);
  CHECK(d.coverage_mismatches == 1);
  CHECK(d.all.differing == 3);
  REQUIRE(d.channels.size() == 2);
  CHECK(d.channels[0].differing == 1);
  CHECK(d.channels[1].differing == 2);
  REQUIRE(d.all.first);
  CHECK(d.all.first->x == 1);
  CHECK(d.all.first->y == 0);
  CHECK(d.all.first->channel == 1);
  CHECK(d.first_a == std::array<float, 4>{0.0f, 0.0f, 0.0f, 0.0f});
  CHECK(d.first_b == std::array<float, 4>{0.0f, 1.0f, 0.0f, 0.0f});
  // With 2 as the background only B's texel (0, 1) is empty.
  CHECK(difference(a, b, {}, {2.0f, 2.0f, 0.0f, 0.0f}).coverage_mismatches == 1);
  CHECK(difference(a, b, {}, {7.0f, 7.0f, 0.0f, 0.0f}).coverage_mismatches == 0);
}

TEST_CASE("difference: sums over all texels, and what is steady, covered or jumps") {
  Image a(Format::RG32F, 4, 1), b(Format::RG32F, 4, 1);
  a.values = {1, 3, 0, 0, 4, 4, 2, 0};
  b.values = {1, 3.015625f, 5, 0, 4, 1, 0, 0};
  const ImageDifference d = difference(a, b);
  CHECK(d.covered == 3);
  CHECK(d.coverage_mismatches == 2);
  // The first texel is another rounding: 1/192 of 3. The others hold something else.
  CHECK(d.jumps == 3);
  CHECK(d.steady.magnitude == 4.0);
  CHECK(d.steady.difference == 0.015625);
  CHECK(d.steady.relative() == 0.015625 / 4.0);
  CHECK(d.sums.a == 14.0);
  CHECK(d.sums.b == 14.015625);
  CHECK(d.sums.difference == 0.015625 + 5.0 + 3.0 + 2.0);
  CHECK(d.sums.relative_total() == 0.015625 / 14.0);
  CHECK(difference(a, a).sums.relative() == 0.0);
  CHECK(std::isinf(difference(Image(Format::RG32F, 4, 1), b).sums.relative()));
}

TEST_CASE("difference: what is dark beside the image's brightest texel does not jump") {
  const auto jumps = [](float dark) { return difference(row({1000.0f, 0.0f}), row({1000.0f, dark})).jumps; };
  CHECK(jumps(0.9e-3f) == 0);
  CHECK(jumps(1.1e-3f) == 1);
  // Beside black, what rounding leaves of 1 - 1.
  CHECK(difference(row({0.0f}), row({0x1p-24f})).jumps == 0);
  CHECK(difference(row({0.0f}), row({1e-5f})).jumps == 1);
  CHECK(difference(row({1e-8f}), row({0.0f})).jumps == 1);
}

TEST_CASE("difference: values beyond one of 255 steps are counted") {
  Image a(Format::RGBA8, 1, 1), b(Format::RGBA8, 1, 1);
  b.values = {1.0f / 255.0f, 2.0f / 255.0f, 0.0f, 1.0f};
  CHECK(difference(a, b).beyond_a_step == 2);
}

TEST_CASE("difference: a channel of interleaved values") {
  const std::vector<float> a = {1, 9, 2, 9, 3, 9, 4, 9}, b = {1, 2, 5, 4};
  const ValueDifference d = difference(ChannelView{a.data(), 2, 2, 2}, ChannelView{b.data(), 1, 2, 2});
  CHECK(d.differing == 1);
  REQUIRE(d.worst);
  CHECK(d.worst->x == 0);
  CHECK(d.worst->y == 1);
  CHECK(d.worst->b == 5.0f);
}
