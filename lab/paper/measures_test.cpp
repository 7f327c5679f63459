#include "lab/paper/measures.hpp"

#include <cmath>

#include "pipeline/shader/constants.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::paper;

namespace {

constexpr double kLanded = STATUS_LANDED, kMissed = STATUS_MISSED, kStopped = STATUS_STOPPED;

Texels row_of(std::vector<std::array<double, 4>> values) {
  return {static_cast<int>(values.size()), 1, std::move(values)};
}

}  // namespace

TEST_CASE("paper rows: a percentile is the value that a share does not exceed") {
  CHECK(percentile({5.0, 1.0, 4.0, 2.0, 3.0}, 0.5) == 3.0);
  CHECK(percentile({5.0, 1.0, 4.0, 2.0, 3.0}, 1.0) == 5.0);
  CHECK(percentile({}, 0.5) == 0.0);
}

TEST_CASE("paper rows: light through a slab lands where Snell's law has it") {
  // sin 30 = 1.5 sin t: tan t = (1/3) / sqrt(8/9) = 0.353553; 0.3 m of glass, 0.5 m of air.
  const Slab slab{.index = 1.5, .incidence = std::asin(0.5)};
  const double shift = 0.3 / std::sqrt(8.0) + 0.5 / std::sqrt(3.0);
  const Texels entry = row_of({{0.0, 0.8, 0.2, 1.0},
                               {0.1, 0.8, 0.0, 1.0},
                               {0.48, 0.8, 0.0, 1.0},
                               {-0.5, 0.6, 0.0, 1.0},
                               {0.0, 0.8, 0.0, 1.0}});
  const Texels landing = row_of({{shift, 0.0, 0.2, kLanded},
                                 {0.1 + shift, 0.0, 0.01, kLanded},
                                 {9.0, 0.0, 0.0, kLanded},    // leaves by the side
                                 {9.0, 0.0, 0.0, kLanded},    // came in by one
                                 {9.0, 0.0, 0.0, kMissed}});  // has no landing
  const std::vector<double> errors = slab_errors(slab, entry, landing);
  REQUIRE(errors.size() == 2);
  CHECK(errors[0] == Approx(0.0).margin(1e-12));
  CHECK(errors[1] == Approx(0.01));
}

TEST_CASE("paper rows: a sphere's landings are measured from the closed form") {
  const GlassSphere sphere{.radius = 0.5, .index = 1.5, .distance = 0.8};
  const double r = sphere.landing(0.25);
  // b = 0.25 as (0.15, 0.2); the second landing is 3 mm off.
  const Texels entry = row_of({{0.15, 0.0, 0.2, 1.0}, {0.15, 0.0, 0.2, 1.0}});
  const Texels landing =
      row_of({{0.6 * r, -0.8, 0.8 * r, kLanded}, {0.6 * r + 0.003, -0.8, 0.8 * r, kStopped}});
  const std::vector<double> errors = sphere_errors(sphere, entry, landing);
  REQUIRE(errors.size() == 2);
  CHECK(errors[0] == Approx(0.0).margin(1e-12));
  CHECK(errors[1] == Approx(0.003));
}

TEST_CASE("paper rows: distances count vertices that landed both times") {
  const Texels a = row_of({{0, 0, 0, kLanded}, {1, 1, 1, kMissed}});
  const Texels b = row_of({{0, 3, 4, kLanded}, {0, 0, 0, kLanded}});
  CHECK(distances(a, b) == std::vector<double>{5.0});
}

TEST_CASE("paper rows: a tint is held against Beer and Lambert") {
  // exp(-(2 - 1) 0.5) for green, exp(-(4 - 1) 0.5) for blue, then blue 1 % too bright; one way is not
  // counted.
  const double green = std::exp(-0.5), blue = std::exp(-1.5);
  const std::array<double, 3> absorption{1.0, 2.0, 4.0};
  const Texels flux = row_of({{1.0, green, blue, 0.0}, {2.0, 2.0 * green, 2.02 * blue, 0.0}, {1, 1, 1, 0}});
  CHECK(worst_tint(row_of({flux.values[0]}), {0.5}, absorption) < 1e-12);
  CHECK(worst_tint(flux, {0.5, 0.5, -1.0}, absorption) == Approx(0.01));
}

TEST_CASE("paper rows: a level floor's positions lie on a lattice") {
  Texels floor{2, 2, {{0, 1, 0, 1}, {2, 1, 0, 1}, {0, 1, -2, 1}, {2, 1, -2, 1}}};
  CHECK(worst_of_lattice(floor) == 0.0);
  floor.values[2][0] = 0.25;
  CHECK(worst_of_lattice(floor) == 0.25);
}

TEST_CASE("paper rows: weights are compared as shares of their sums") {
  // Shares 2/3, 1/3 against 1/4, 3/4: 5/6. Flux times literal weights is 2, 3: shares 2/5, 3/5, so 0.3.
  const WeightErrors errors = weight_errors({.flux = {2.0, 1.0}, .literal = {10.0, 30.0}});
  CHECK(errors.literal == Approx(5.0 / 6.0));
  CHECK(errors.equal_parts == Approx(0.3));
}

TEST_CASE("paper rows: a sphere under a lamp two radii away has the flux and cosines of the closed forms") {
  // Half angle 30 degrees, so t^2 < 1/3: the mean of (1 + t^2)^-1.5 over the disc is 6 (1 - cos 30). The mean
  // of N.L is 2 pi / sqrt(3) - 3 there: 3 times the integral of sqrt(4 u - 3) / u^2 from 3/4 to 1, u = cos^2.
  const VertexWeights weights = weights_under_lamp(2.0);
  const auto count = static_cast<double>(weights.flux.size());
  CHECK(sum_of(weights.flux) / count == Approx(6.0 * (1.0 - std::sqrt(0.75))).epsilon(1e-6));
  CHECK(sum_of(weights.literal) / sum_of(weights.flux) ==
        Approx(2.0 * 3.14159265358979 / std::sqrt(3.0) - 3.0).epsilon(1e-5));
}

TEST_CASE(
    "paper rows: V in equal parts is right in parallel light, and 9.6 % off under a lamp at two radii") {
  // A far lamp: N.L alone is left. Its square is even from 0 to 1, so its mean is 2/3, and 1.5 N.L is 8/27
  // away from 1 in the mean.
  const WeightErrors far = weight_errors(weights_under_lamp(1e4));
  CHECK(far.equal_parts == Approx(0.0).margin(1e-6));
  CHECK(far.literal == Approx(8.0 / 27.0).epsilon(1e-5));
  CHECK(weight_errors(weights_under_lamp(2.0)).equal_parts == Approx(0.096).margin(5e-4));
}
