// Keyframes against values computed by hand from glTF 2.0 appendix C.
#include "pipeline/scene/keyframes.hpp"

#include <cmath>

#include "pipeline/scene/exact.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

Keyframes scalar(KeyframeInterpolation interpolation, std::vector<float> times, std::vector<float> values) {
  return {.interpolation = interpolation, .width = 1, .times = std::move(times), .values = std::move(values)};
}

double at(const Keyframes& keys, double seconds) { return keys.at(seconds)[0]; }

constexpr double kSin15 = 0.25881904510252074, kCos15 = 0.96592582628906831;

// From no turn to a quarter turn about y in two seconds; `sign` chooses one of its two quaternions.
Keyframes quarter_turn(KeyframeInterpolation interpolation, float sign) {
  const float half = std::sqrt(0.5f);
  return {.interpolation = interpolation,
          .rotation = true,
          .width = 4,
          .times = {0.0f, 2.0f},
          .values = {0, 0, 0, 1, 0, sign * half, 0, sign * half}};
}

}  // namespace

TEST_CASE("Stepped keyframes hold a value until the next moment") {
  const Keyframes keys = scalar(KeyframeInterpolation::Step, {1, 2, 4}, {10, 20, 30});
  CHECK(at(keys, 0.0) == 10);
  CHECK(at(keys, 1.0) == 10);
  CHECK(at(keys, 1.9999) == 10);
  CHECK(at(keys, 2.0) == 20);
  CHECK(at(keys, 3.9999) == 20);
  CHECK(at(keys, 4.0) == 30);
  CHECK(at(keys, 100.0) == 30);
}

TEST_CASE("Linear keyframes go straight from value to value and stay before and after") {
  const Keyframes keys = scalar(KeyframeInterpolation::Linear, {1, 2, 4}, {10, 20, -20});
  CHECK(at(keys, 0.5) == 10);
  CHECK(at(keys, 1.25) == 12.5);
  CHECK(at(keys, 2.0) == 20);
  CHECK(at(keys, 3.0) == 0);
  CHECK(at(keys, 3.5) == -10);
  CHECK(at(keys, 9.0) == -20);
}

TEST_CASE("A cubic spline meets its values and uses tangents per second") {
  // In-tangent, value, out-tangent. Half way: 1/2 * 1 + 2 s * 1/8 * 2 + 1/2 * 5 - 2 s * 1/8 * (-1).
  const Keyframes keys = scalar(KeyframeInterpolation::CubicSpline, {1, 3}, {99, 1, 2, -1, 5, 99});
  CHECK(at(keys, 0.0) == 1);
  CHECK(at(keys, 1.0) == 1);
  CHECK(at(keys, 2.0) == 3.75);
  CHECK(at(keys, 3.0) == 5);
  CHECK(at(keys, 4.0) == 5);
  // A quarter: h00 = 27/32, h10 = 9/64, h01 = 5/32, h11 = -3/64.
  CHECK(at(keys, 1.5) == Approx(27.0 / 32 + 2 * 9.0 / 64 * 2 + 5 * 5.0 / 32 + 2 * 3.0 / 64));
}

TEST_CASE("Rotations turn at an even pace along the shorter way") {
  for (const float sign : {1.0f, -1.0f}) {
    const std::vector<double> third = quarter_turn(KeyframeInterpolation::Linear, sign).at(2.0 / 3);
    CHECK(third[0] == 0);
    CHECK(third[1] == Approx(kSin15).epsilon(1e-7));
    CHECK(third[2] == 0);
    CHECK(third[3] == Approx(kCos15).epsilon(1e-7));
  }
  const std::vector<double> stepped = quarter_turn(KeyframeInterpolation::Step, 1.0f).at(1.9);
  CHECK(stepped == std::vector<double>{0, 0, 0, 1});
}

TEST_CASE("A spherical interpolation agrees with its definition") {
  const double a[4] = {0, 0, 0, 1};
  for (const double degrees : {1e-9, 0.001, 1.0, 60.0, 120.0, 179.0}) {
    const double half = degrees * exact::kPi / 360.0;
    const double b[4] = {std::sin(half), 0, 0, std::cos(half)};
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      double q[4];
      slerp(a, b, share, q);
      INFO(degrees << " degrees, share " << share);
      CHECK(std::abs(q[0] - std::sin(share * half)) < 1e-15);
      CHECK(std::abs(q[3] - std::cos(share * half)) < 1e-15);
    }
  }
  double same[4];
  slerp(a, a, 0.3, same);
  CHECK(same[3] == 1);
}

TEST_CASE("Rotations that are no unit quaternions give one all the same") {
  Keyframes keys = quarter_turn(KeyframeInterpolation::Linear, 1.0f);
  keys.values = {0, 0, 0, 5, 0, 0, 0, 0};
  for (const double seconds : {0.0, 1.0, 2.0}) {
    const std::vector<double> q = keys.at(seconds);
    CHECK(q == std::vector<double>{0, 0, 0, 1});
  }
  // A spline through opposite quaternions passes zero half way.
  keys.interpolation = KeyframeInterpolation::CubicSpline;
  keys.values = {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0};
  CHECK(keys.at(1.0) == std::vector<double>{0, 0, 0, 1});
}

TEST_CASE("The exact arctangent agrees with known angles and the library") {
  CHECK(exact::arctangent(0.0) == 0.0);
  CHECK(exact::arctangent(1.0) == Approx(exact::kPi / 4).epsilon(1e-15));
  CHECK(exact::arctangent(1.0 / std::sqrt(3.0)) == Approx(exact::kPi / 6).epsilon(1e-15));
  CHECK(exact::arctangent(std::numeric_limits<double>::infinity()) == exact::kPi / 2);
  for (double x = 1e-12; x < 1e12; x *= 1.37) {
    CHECK(std::abs(exact::arctangent(x) - std::atan(x)) <= 1e-15 * std::atan(x));
    CHECK(exact::arctangent(-x) == -exact::arctangent(x));
  }
}
