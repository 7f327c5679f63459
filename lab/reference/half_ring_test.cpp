// The counted half ring against the closed form of single rays.
#include "lab/reference/half_ring.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("Half ring: all light that the wall takes is counted") {
  const HalfRing ring{.radius = 1.0, .reach = 0.4};
  double sum = 0.0;
  for (const double value : irradiance_average(ring, {glm::dvec2(-2.0), 4.0, 64})) sum += value;
  // A wall of 2 R across the light, which falls on `reach` metres of floor.
  CHECK(sum / 256.0 == Approx(2.0 * 0.4).epsilon(1e-5));
}

TEST_CASE("Half ring: pixel means are those of the single branch near the wall") {
  const HalfRing ring{.radius = 1.0, .reach = 0.4};
  for (const double s : {0.1, 0.2, 0.3}) {
    const std::vector<double> one =
        irradiance_average(ring, {glm::dvec2(1.0 - s - 0.005, -0.005), 0.01, 1}, 128);
    CHECK(one[0] == Approx(ring_irradiance(1.0, 0.0, s)).epsilon(0.01));
  }
}

TEST_CASE("Half ring: its light ends at the nephroid") {
  // Beyond the cusp, on the axis, three rays meet: more light than just before it.
  const HalfRing ring{.radius = 1.0, .reach = 0.8};
  const auto at = [&](double x) { return irradiance_average(ring, {glm::dvec2(x, -0.005), 0.01, 1}, 64)[0]; };
  CHECK(at(0.51) > 2.0 * at(0.45));
  CHECK(at(0.51) > 2.0 * at(0.6));
}
