// The exact functions of the common subset within the bounds that functions.glsl states for them, in one
// lane: the C library in double precision is the witness. That every lane width and OpenGL give the same bits
// is for the tests of determinism and parity.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#define CAUSTICS_LANES 1
#define CAUSTICS_LANE_NAMESPACE functions_test
#include "pipeline/shader/stage.hpp"
#include "tests/support/catch.hpp"

namespace caustics::functions_test {

namespace {

struct Functions {
#include "pipeline/shader/functions.glsl"
};

Functions f;
const Float kNaN = std::numeric_limits<float>::quiet_NaN();

// The largest error over evenly spaced arguments.
template <class Error>
double worst(double from, double to, Error error) {
  double largest = 0.0;
  for (int i = 0; i <= 20000; ++i)
    largest = std::max(largest, error(static_cast<float>(from + (to - from) * i / 20000.0)));
  return largest;
}

}  // namespace

TEST_CASE("exact functions: the exponential errs by less than 3e-7 of itself") {
  CHECK(worst(-87.0, 88.0,
              [](float x) { return std::fabs(double(f.exp_of(x).v) / std::exp(double(x)) - 1.0); }) < 3e-7);
  CHECK(f.exp_of(-87.001f) == 0.0f);
  CHECK(f.exp_of(1000.0f) == f.exp_of(88.0f));
}

TEST_CASE("exact functions: the logarithm errs by less than 1e-6") {
  const auto error = [](float x) {
    const double expected = std::log(double(x));
    return std::fabs(double(f.log_of(x).v) - expected) / std::max(1.0, std::fabs(expected));
  };
  CHECK(worst(0.01, 3.0, error) < 1e-6);
  CHECK(worst(-87.0, 88.0, [&](float x) { return error(static_cast<float>(std::exp(double(x)))); }) < 1e-6);
  CHECK(f.log_of(0.0f).v == Approx(-126.0 * std::log(2.0)));
}

TEST_CASE("exact functions: powers, the error function and the arctangent keep to their bounds") {
  CHECK(worst(0.0, 4.0, [](float x) {
          return std::fabs(double(f.pow_of(x, 0.4f).v) - std::pow(double(x), double(0.4f)));
        }) < 2e-6);
  CHECK(f.pow_of(0.0f, 2.0f) == 0.0f);
  CHECK(f.pow_of(-1.0f, 2.0f) == 0.0f);
  CHECK(worst(-7.0, 7.0, [](float x) { return std::fabs(double(f.erf_of(x).v) - std::erf(double(x))); }) <
        2e-6);
  CHECK(worst(-3.15, 3.15, [](float turn) {
          const float y = 3.0f * std::sin(turn), x = 3.0f * std::cos(turn);
          return std::fabs(double(f.atan2_of(y, x).v) - std::atan2(double(y), double(x)));
        }) < 4e-6);
  CHECK(f.atan2_of(0.0f, 0.0f) == 0.0f);
}

TEST_CASE("exact functions: whole powers of two are exact") {
  for (int n = -126; n <= 127; ++n) CHECK(f.exp2_of_whole(n) == std::ldexp(1.0f, n));
}

TEST_CASE("exact functions: comparisons choose the second of two where one is not a number") {
  CHECK(f.min_of(kNaN, 2.0f) == 2.0f);
  CHECK(f.max_of(kNaN, 2.0f) == 2.0f);
  CHECK(f.clamp_to(kNaN, 1.0f, 2.0f) == 1.0f);
  CHECK(f.clamp_to(Float(3.0f), 1.0f, 2.0f) == 2.0f);
  CHECK(f.floor_to_int(-0.5f) == -1);
  CHECK(f.floor_to_int(kNaN) == -16777216);
  CHECK(f.inside_unit(0.0f, 0.999f));
  CHECK_FALSE(f.inside_unit(1.0f, 0.5f));
  CHECK_FALSE(f.inside_unit(kNaN, 0.5f));
}

TEST_CASE("exact functions: a matrix' columns are summed by a point's components") {
  const mat4 m{{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}}};
  const Vec4 p = f.transform_point(m, Vec3(1.0f, 10.0f, 100.0f));
  const Vec3 v = f.transform_vector(m, Vec3(1.0f, 10.0f, 100.0f));
  CHECK(p.x == 964.0f);
  CHECK(p.y == 1076.0f);
  CHECK(p.z == 1188.0f);
  CHECK(p.w == 1300.0f);
  CHECK(v.x == 951.0f);
  CHECK(v.y == 1062.0f);
  CHECK(v.z == 1173.0f);
}

TEST_CASE("exact functions: one lane counts its operations on floats, and none of whole numbers") {
  const auto counted = [](auto work) {
    const std::uint64_t before = operations_of_thread;
    work();
    return operations_of_thread - before;
  };
  const Vec3 v(1.0f, 2.0f, 3.0f);
  CHECK(counted([&] { f.dot3(v, v); }) == 5);        // three products, two sums
  CHECK(counted([&] { f.length3(v); }) == 6);        // and a root
  CHECK(counted([&] { f.min_of(v.x, v.y); }) == 2);  // a comparison, a choice
  CHECK(counted([&] { f.min_of(1, 2); }) == 0);
}

TEST_CASE("exact functions: what has no length has the fallback's direction") {
  const Vec3 up(0.0f, 1.0f, 0.0f);
  CHECK(f.normalize_or(Vec3(1e-16f, 0.0f, 0.0f), up).y == 1.0f);
  CHECK(f.normalize_or(Vec3(kNaN, 0.0f, 0.0f), up).y == 1.0f);
  CHECK(f.normalize_or(Vec3(0.0f, 0.0f, -3.0f), up).z == -1.0f);
}

}  // namespace caustics::functions_test
