#include "pipeline/views/landing_window.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("landing window: a map's texels are eight roundings wide or more, of what carries light") {
  // Single precision moves the first landing by a micrometre; the second has no light, and does not count.
  const std::vector<WeightedPoint> points = {{.weight = 1.0, .rounding = 1e-6}, {.rounding = 1.0}};
  const LandedFlux landed(points);
  CHECK(landed.shortest_side(100) == Approx(8e-4));
  CHECK(landed.shortest_side(200) == Approx(16e-4));
}

TEST_CASE("landing window: where nothing is rounded a window has a nanometre a side all the same") {
  const std::vector<WeightedPoint> exact = {{.weight = 1.0}};
  CHECK(LandedFlux(exact).shortest_side(100) == Approx(1e-9));
}
