// The exact arithmetic against the C library, which is only a witness here.
#include "pipeline/scene/exact.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"

using namespace caustics::exact;

TEST_CASE("Sine and cosine agree with the C library to 2e-15") {
  double worst = 0;
  for (int i = -2000; i <= 2000; ++i)
    for (const double angle : {i * 0.37, i * 49.9}) {
      double s = 0, c = 0;
      sin_cos(angle, s, c);
      worst = std::max({worst, std::abs(s - std::sin(angle)), std::abs(c - std::cos(angle))});
    }
  CHECK(worst < 2e-15);
}

TEST_CASE("The exact logarithm agrees with the C library to 2e-15") {
  double worst = 0;
  for (int i = -3000; i <= 3000; ++i) {
    const double x = std::exp(i * 0.2), expected = std::log(x);
    worst = std::max(worst, std::abs(caustics::exact::log(x) - expected) / std::max(1.0, std::abs(expected)));
  }
  CHECK(worst < 2e-15);
}

TEST_CASE("The exact exponential agrees with the C library to 2e-15 of it") {
  double worst = 0;
  for (int i = -3000; i <= 3000; ++i) {
    const double x = i * 0.23, expected = std::exp(x);
    worst = std::max(worst, std::abs(caustics::exact::exp(x) - expected) / expected);
  }
  CHECK(worst < 2e-15);
  CHECK(caustics::exact::exp(0.0) == 1.0);
  CHECK(caustics::exact::exp(-1e9) == 0.0);
}

TEST_CASE("The sRGB curve agrees with the C library's pow") {
  for (int i = 0; i <= 255; ++i) {
    const double x = i / 255.0;
    const double expected = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    CHECK(std::abs(srgb_to_linear(x) - expected) < 1e-15);
  }
  CHECK(srgb_to_linear(1.0) == 1.0);
}

TEST_CASE("Lengths neither overflow nor underflow") {
  CHECK(length({3e200, 4e200, 0}) == Approx(5e200));
  CHECK(length({3e-200, 4e-200, 0}) == Approx(5e-200));
  CHECK(length({0, 0, 0}) == 0.0);
  CHECK(normalise({0, 0, 1e-300}, {1, 0, 0}) == glm::dvec3(0, 0, 1));
  CHECK(normalise({0, 0, 0}, {1, 0, 0}) == glm::dvec3(1, 0, 0));
}

TEST_CASE("A perpendicular is one, whatever the direction") {
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 n = normalise({(i % 10) - 4.5, ((i / 10) % 10) - 4.5, (i / 100) - 4.5}, {1, 0, 0});
    CHECK(std::abs(dot(n, perpendicular(n))) < 1e-15);
    CHECK(length(perpendicular(n)) == Approx(1));
  }
  for (const glm::dvec3& axis : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {0.8, 0.6, 0}}) {
    CHECK(std::abs(dot(axis, perpendicular(axis))) < 1e-15);
    CHECK(length(perpendicular(axis)) == Approx(1));
  }
}

TEST_CASE("Normals stay perpendicular to surfaces that are stretched and mirrored") {
  Affine stretch;
  stretch.x = {-3, 0, 0};
  stretch.y = {1, 2, 0};
  const glm::dvec3 in_surface = stretch.direction({0, 1, 0});
  CHECK(dot(stretch.normal({1, 0, 0}), in_surface) == Approx(0).margin(1e-12));
  CHECK(stretch.normal({1, 0, 0}).x < 0);
}
