// The floor of a whole ring against that of the half ring that is lit from inside.
#include "lab/reference/ring_floor.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "lab/reference/half_ring.hpp"
#include "tests/support/catch.hpp"

namespace caustics {

namespace {

const MetalRing kRing{.inner = 1.0, .outer = 1.1, .height = 0.3, .elevation = 0.25 * std::numbers::pi};

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

TEST_CASE("ring floor: away from the other rim's shadow the inner wall draws what half a ring draws") {
  // Light runs 0.3 m far, so that here it comes from the middle of the wall.
  const FloorSquare floor{.lower = {0.7, -0.15}, .side = 0.3, .pixels = 3};
  const std::vector<double> whole = irradiance_average(kRing, floor);
  const std::vector<double> half = irradiance_average(HalfRing{.radius = 1.0, .reach = 0.3}, floor, 200);
  for (std::size_t i = 0; i < whole.size(); ++i)
    CHECK(whole[i] == Approx(half[i] * std::sin(kRing.elevation)).epsilon(2e-3));
}

TEST_CASE("ring floor: all light that meets its walls lands, and metal mirrors most at grazing") {
  const FloorSquare all{.lower = {-2.0, -2.0}, .side = 4.0, .pixels = 7};
  const auto flux = [&](const MetalRing& ring) {
    return sum(irradiance_average(ring, all)) * std::pow(4.0 / 7.0, 2.0);
  };
  // Outside a rectangle across the light, 2 R wide; inside that of the inner wall, less what lies in shadow:
  // where a chord is shorter than the wall's reach, 2 R cos t < 0.3, a part 1 - 2 R cos t / 0.3 of it.
  const double turn = std::acos(0.15);  // the shadow begins
  const double shadow =
      2.0 * (1.0 - std::sin(turn)) - 2.0 * (0.5 * std::numbers::pi - turn - 0.15 * std::sin(turn)) / 0.3;
  const double expected = 0.3 * std::cos(kRing.elevation) * (2.0 * 1.1 + 2.0 - shadow);
  CHECK(flux(kRing) == Approx(expected).epsilon(1e-6));
  MetalRing gold = kRing;
  gold.reflectance = 0.78;
  CHECK(flux(gold) > 0.78 * expected);
  CHECK(flux(gold) < 0.82 * expected);
}

}  // namespace caustics
