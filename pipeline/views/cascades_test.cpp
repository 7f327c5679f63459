#include "pipeline/views/cascades.hpp"

#include "pipeline/settings/settings.hpp"
#include "pipeline/settings/splat_kernel.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

// n x n points over a square around the origin, `weight` in all.
void add_square(std::vector<WeightedPoint>& points, int n, double side, double weight) {
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      points.push_back({side * ((glm::dvec2(x, y) + 0.5) / double(n) - 0.5), weight / (n * n)});
}

View square_view(double side) {
  View view;
  view.window_lower = glm::dvec2(-0.5 * side);
  view.window_upper = glm::dvec2(0.5 * side);
  return view;
}

}  // namespace

TEST_CASE("cascades: light that fills its map evenly has none") {
  std::vector<WeightedPoint> points;
  add_square(points, 40, 1.0, 1.0);
  CHECK_FALSE(cascade_view(square_view(1.0), LandedFlux(points), 0.0));
}

TEST_CASE("cascades: a bright spot in a faint halo has one around the spot") {
  std::vector<WeightedPoint> points;
  add_square(points, 40, 10.0, 0.05);
  add_square(points, 40, 1.0, 0.95);
  const std::optional<View> cascade = cascade_view(square_view(10.0), LandedFlux(points), 0.0);
  REQUIRE(cascade);
  CHECK(cascade->window_upper.x - cascade->window_lower.x == Approx(1.0).epsilon(0.25));
  CHECK(cascade->window_lower.y == Approx(-cascade->window_upper.y));
}

TEST_CASE("cascades: what is looked up of one is whole texels of the map, and a hundredth of one around") {
  // Texels of half a metre, of which it touches four along x and three along y.
  Settings settings;
  settings.map = 32;
  View cascade = square_view(16.0);
  cascade.window_lower = {-0.9, 1.6};
  cascade.window_upper = {0.6, 2.6};
  cascade = covering_texels(cascade, square_view(16.0), settings).value();
  const double border = cascade_border(settings) / 32.0;
  const glm::dvec2 size = cascade.window_upper - cascade.window_lower;
  const glm::dvec2 lower = cascade.window_lower + border * size, upper = cascade.window_upper - border * size;
  CHECK(lower.x == Approx(-1.005));
  CHECK(upper.x == Approx(1.005));
  CHECK(lower.y == Approx(1.495));
  CHECK(upper.y == Approx(3.005));
}

TEST_CASE("cascades: where half of one or more would be border, there is none") {
  // Three sigma and a texel: 3.1 and 13 texels.
  Settings settings;
  for (const auto& [sigma, least] : {std::pair(0.7f, 13), {4.0f, 52}}) {
    settings.gaussian_sigma = sigma;
    settings.map = least;
    CHECK(can_have_cascades(settings));
    settings.map = least - 1;
    CHECK_FALSE(can_have_cascades(settings));
    CHECK(why_no_cascades(settings) == "half of one would be border; a larger --map has room");
  }
}

TEST_CASE("cascades: one that whole texels and its border make too wide to be worth it is none") {
  Settings settings;
  settings.map = 16;
  View cascade = square_view(7.0);
  CHECK_FALSE(covering_texels(cascade, square_view(16.0), settings));
  cascade = square_view(2.0);
  CHECK(covering_texels(cascade, square_view(16.0), settings));
}

TEST_CASE("cascades: a window takes in the whole of a bright spot, whatever share of the light lies apart") {
  for (const double apart : {0.02, 0.05, 0.09}) {
    std::vector<WeightedPoint> points;
    add_square(points, 40, 40.0, apart);
    add_square(points, 60, 1.0, 1.0 - apart);
    const std::optional<View> cascade = cascade_view(square_view(40.0), LandedFlux(points), 0.0);
    REQUIRE(cascade);
    INFO(apart);
    CHECK(cascade->window_upper.x - cascade->window_lower.x > 0.95);
  }
}

TEST_CASE("landed flux: a window leaves out the share that it may at each end") {
  std::vector<WeightedPoint> points;
  points.reserve(100);
  for (int i = 0; i < 100; ++i) points.push_back({{double(i * i), 0.0}, 1.0});
  const LandedFlux landed(points);
  // Summed from either end, the tenth point reaches a tenth of the flux.
  const Window window = landed.window(0.1);
  CHECK(window.lower.x == 81.0);
  CHECK(window.upper.x == 8100.0);
  CHECK(landed.share_in(window) == Approx(0.82));
}

TEST_CASE("cascades: the effect tells which lights have one") {
  const Settings settings;
  Effects effects;
  effects.lights.resize(2);
  LightViews with, without;
  with.caustic = without.caustic = square_view(4.0);
  with.cascade = square_view(1.0);
  const Effects one = with_findings(effects, settings, findings_of({without, with}, effects));
  CHECK(one.cascades.active);
  CHECK(one.lights[0].cascade.empty());
  CHECK(one.lights[1].cascade == "most of its light falls on 1/16 of its map's area");
  const Effects none = with_findings(effects, settings, findings_of({without, without}, effects));
  CHECK_FALSE(none.cascades.active);
  CHECK(none.cascades.reason == "no light's caustic is small in its map");
}
