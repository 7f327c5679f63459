// Kernels narrower than a texel and wider than the map, maps of one texel, sums of a million splats.
#include <cmath>

#include "tests/stability/hard_case.hpp"
#include "tests/support/catch.hpp"

namespace caustics::test {

namespace {

HardCase splatted(const std::string& name, const std::string& behaviour, Splat splat, int grid, int map) {
  HardCase c{name, behaviour, sphere_scene(1.5f, 4)};
  c.settings = through_two_surfaces(small_settings(grid, map, 24));
  c.settings.splat = splat;
  return c;
}

HardCase gaussian_case(float sigma, int map) {
  char text[96];
  std::snprintf(text, sizeof text, "a Gaussian of %g texels on a map of %d", static_cast<double>(sigma), map);
  const bool wider = 6.0 * static_cast<double>(sigma) > map;
  HardCase c = splatted(text,
                        wider ? "the part beyond the map is booked as its edge's"
                              : "keeps its mass: weights are integrals over texels",
                        Splat::Gaussian, 48, map);
  c.settings.gaussian_sigma = sigma;
  c.expect = [wider](const DrawnCase& drawn) {
    if (wider) {
      CHECK(drawn.share(&Ledger::kernel_edge) > 0.1);
    } else {
      CHECK(drawn.leaves() == Approx(0.8355).margin(0.02));
    }
  };
  return c;
}

// Parallel light through a level plate, so that each of a million vertices gives the one texel the same.
HardCase million_case() {
  HardCase c =
      splatted("a million splats into one texel",
               "single precision loses part of the sum: measured, booked as rounding, and below n 2^-24",
               Splat::Point, 1024, 1);
  c.scene.meshes[1] = box({-0.4, 0.5, -0.4}, {0.4, 0.6, 0.4}, 1);
  c.expect = [](const DrawnCase& drawn) {
    const Ledger& ledger = drawn.ledger();
    const auto landed = ledger.vertices[static_cast<std::size_t>(LandingStatus::Landed)];
    CHECK(landed > 900000);
    // The bound itself, from its formula: n splats in the only texel.
    CHECK(ledger.rounding_bound[1] ==
          Approx(static_cast<double>(landed) * 0x1p-24 * ledger.in_map[1]).epsilon(0.01));
    CHECK(std::fabs(ledger.rounding[1]) <= ledger.rounding_bound[1]);
    CHECK(std::fabs(ledger.rounding[1]) > 1e-5 * ledger.entered[1]);  // it is there to be seen
    CHECK(drawn.leaves() == Approx(0.96 * 0.96).margin(0.005));
  };
  return c;
}

HardCase least_case() {
  HardCase c =
      splatted("grid, maps and picture of one texel", "one ray, one splat, one pixel", Splat::Cell, 1, 1);
  c.settings.width = c.settings.height = c.settings.shadow = 1;
  return c;
}

HardCase flat_picture_case() {
  HardCase c = splatted("a picture of 1 by 64 pixels", "drawn", Splat::Cell, 48, 64);
  c.settings.width = 1;
  c.settings.height = 64;
  return c;
}

HardCase coarse_case(Splat splat) {
  return splatted("a grid of 2 on a map of 64, " + std::string(name_of(splat)), "few rays; books close",
                  splat, 2, 64);
}

// One ray through a plate that stands away from the axes, so that no coordinate is exact.
HardCase point_case(Splat splat) {
  HardCase c = splatted("a caustic narrower than its coordinates' rounding, " + std::string(name_of(splat)),
                        "the map is some thousand roundings wide and has the whole splat", splat, 1, 64);
  c.scene.meshes[1] = box({-0.524, 0.5, -0.825}, {0.277, 0.6, -0.225}, 1);
  c.expect = [](const DrawnCase& drawn) {
    CHECK(drawn.share(&Ledger::in_map) == Approx(0.96 * 0.96).margin(0.005));
    CHECK(drawn.share(&Ledger::kernel_edge) < 1e-6);
    const View& view = drawn.rendering.views.front().caustic;
    CHECK(view.window_area() >
          std::pow(64 * 8 * 0x1p-24 * 0.5, 2.0));  // it lies more than half a metre from the origin
    CHECK(view.window_area() < 1e-6);
  };
  return c;
}

HardCase no_margin_case(double share) {
  HardCase c =
      splatted(share > 0.0 ? "half of the flux may fall outside the map" : "no flux may fall outside the map",
               "what falls outside is booked", Splat::Cell, 48, 64);
  c.settings.outside_share = share;
  c.scene.lights = {sun({0.9, -1.0, 0.3}, 1.0f)};
  return c;
}

}  // namespace

std::vector<HardCase> map_cases() {
  std::vector<HardCase> cases;
  cases.push_back(gaussian_case(0.1f, 64));
  cases.push_back(gaussian_case(4.0f, 64));
  cases.push_back(gaussian_case(4.0f, 4));
  for (const Splat splat : {Splat::Point, Splat::Gaussian, Splat::Cell})
    cases.push_back(
        splatted("a map of one texel, " + std::string(name_of(splat)), "holds all that lands", splat, 48, 1));
  cases.push_back(least_case());
  cases.push_back(flat_picture_case());
  for (const Splat splat : {Splat::Point, Splat::Cell}) cases.push_back(coarse_case(splat));
  cases.push_back(no_margin_case(0.0));
  cases.push_back(no_margin_case(0.5));
  for (const Splat splat : {Splat::Point, Splat::Gaussian, Splat::Cell}) cases.push_back(point_case(splat));
  cases.push_back(million_case());
  return cases;
}

}  // namespace caustics::test
