// Flat-sided glass against the closed forms of one interface, a slab and a prism.
#include "lab/reference/glass_bar.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

namespace caustics {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

// Of a picture: its light over E_perp, square metres, and the middle of that along x.
struct Light {
  double flux = 0.0, middle = 0.0;
};
Light light_of(const GlassBar& bar, const FloorSquare& floor) {
  const std::vector<double> values = irradiance_average(bar, floor);
  const double pixel = floor.side / floor.pixels;
  Light light;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double flux = values[i] * pixel * pixel;
    light.flux += flux;
    const auto column = static_cast<double>(i % static_cast<std::size_t>(floor.pixels));
    light.middle += flux * (floor.lower.x + pixel * (column + 0.5));
  }
  light.middle /= light.flux;
  return light;
}

}  // namespace

TEST_CASE("glass bar: a wide slab dims and shifts the light as its closed forms say") {
  const double lean = 40.0 * kDegree;
  const GlassBar bar{.corners = {{-5.0, 0.5}, {5.0, 0.5}, {5.0, 0.8}, {-5.0, 0.8}},
                     .half_length = 5.0,
                     .travel = {std::sin(lean), -std::cos(lean)},
                     .index = 1.5};
  const std::vector<double> values =
      irradiance_average(bar, {.lower = {-1.0, -1.0}, .side = 2.0, .pixels = 4});
  for (const double value : values)
    CHECK(value == Approx(std::cos(lean) * slab_transmittance(lean, 1.5, 0.3)).epsilon(1e-12));
  // The far end of what is lit: the lower side's edge, straight on to the floor.
  const std::vector<double> edge = irradiance_average(bar, {.lower = {5.0, -0.5}, .side = 1.0, .pixels = 1});
  CHECK(edge[0] / values[0] == Approx(0.5 * std::tan(lean)).epsilon(1e-12));
  CHECK(irradiance_average(bar, {.lower = {7.0, -0.5}, .side = 1.0, .pixels = 1})[0] == 0.0);
  CHECK(irradiance_average(bar, {.lower = {0.0, 6.0}, .side = 1.0, .pixels = 1})[0] == 0.0);
  // The near end lies where the upper side's edge would be lit, less the slab's shift.
  const std::vector<double> near = irradiance_average(bar, {.lower = {-5.0, -0.5}, .side = 1.0, .pixels = 1});
  CHECK(near[0] / values[0] ==
        Approx(1.0 - (0.8 * std::tan(lean) - slab_floor_shift(lean, 1.5, 0.3))).epsilon(1e-12));
}

TEST_CASE("glass bar: a wedge turns light as a prism of its angle does") {
  const double apex = 20.0 * kDegree, deviation = *prism_deviation(apex, 1.5, 0.0);
  const FloorSquare floor{.lower = {-2.0, -2.0}, .side = 4.0, .pixels = 400};
  Light light[2];
  for (int i = 0; i < 2; ++i) {
    const double low = 0.5 + i;  // one metre higher, light lands tan(deviation) farther
    light[i] = light_of(
        {.corners = {{0.0, low}, {0.2, low + 0.2 * std::tan(apex)}, {0.0, low + 0.2 * std::tan(apex)}},
         .half_length = 0.3,
         .index = 1.5},
        floor);
  }
  CHECK(std::fabs(light[1].middle - light[0].middle) == Approx(std::tan(deviation)).epsilon(1e-3));
  const double passed =
      (1.0 - fresnel(1.0, 1.0, 1.5).mean()) * (1.0 - fresnel(std::cos(apex), 1.5, 1.0).mean());
  CHECK(light[0].flux == Approx(0.2 * 0.6 * passed).epsilon(1e-12));
}

}  // namespace caustics
