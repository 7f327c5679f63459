#include "tests/support/landing_bench.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("landing: the secant meets a tilted plane exactly") {
  // The ray x = -s t, y = 1 - c t with tan = s / c from 30 degrees' tilt meets y = 0.3 x where
  // 1 - c t = -0.3 s t.
  LandingBench bench;
  bench.normal = tilted(30.0);
  bench.receiver = bench.floor_map(64, 0.0, 0.3);
  bench.iterations = 2;
  const double s = std::sin(0.183762), c = std::cos(0.183762);
  const double t = 1.0 / (c - 0.3 * s);
  const PassImages out = bench.run();
  REQUIRE(landing_status(out) == LandingStatus::Landed);
  CHECK(out["landing"].at(0, 0, 0) == Approx(-s * t).epsilon(1e-4));
  CHECK(out["landing"].at(0, 0, 1) == Approx(-0.3 * s * t).epsilon(1e-3));
}

TEST_CASE("landing: the paper's estimator contracts by the squared sine on a level plane") {
  // x_{k+1}^2 - x*^2 = sin^2(theta) (x_k^2 - x*^2), started at 0 (from x_{k+1}^2 = h^2 +
  // (x_k sin theta)^2). After k steps x^2 = x*^2 (1 - sin^(2k) theta); with nearest texels of 1/8 m at
  // theta = 10.5 degrees the quantisation of the look-up is what remains.
  LandingBench bench;
  bench.normal = tilted(30.0);
  bench.estimator = ESTIMATOR_PAPER;
  bench.receiver = bench.floor_map(1024, 0.0, 0.0);
  const double theta = 0.183762, exact = 1.0 / std::cos(theta);
  for (const int k : {1, 2, 3}) {
    bench.iterations = k;
    const glm::vec4 p = texel(bench.run()["landing"], 0, 0);
    const double x = std::hypot(double(p.x), 1.0 - double(p.y));
    CHECK(x == Approx(exact * std::sqrt(1.0 - std::pow(std::sin(theta), 2 * k))).margin(8.0 / 1024));
  }
}

TEST_CASE("landing: Newton's method meets a plane whatever its slope") {
  // f is linear along a ray to a plane, so a forward difference is exact but for rounding, and but for a
  // stencil that straddles the root, which the guard catches.
  for (const double slope : {0.0, 0.3, -0.3, 0.8}) {
    LandingBench bench;
    bench.normal = tilted(30.0);
    bench.estimator = ESTIMATOR_NEWTON;
    bench.receiver = bench.floor_map(64, 0.0, slope);
    const PassImages out = bench.run();
    REQUIRE(landing_status(out) == LandingStatus::Landed);
    // The ray leans 10.5288 degrees towards -x: y = 1 + x / tan, and y = slope x.
    const double x = 1.0 / (slope - 1.0 / std::tan(10.5288 * 3.14159265358979323846 / 180.0));
    CHECK(texel(out["landing"], 0, 0).x == Approx(x).margin(2e-4));
  }
}

TEST_CASE("landing: Newton's method is held where its slope is none") {
  // A step of 3 m under the ray: whatever happens there, every value stays finite and in range.
  LandingBench bench;
  bench.normal = tilted(30.0);
  bench.estimator = ESTIMATOR_NEWTON;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 32; ++x) bench.receiver.at(x, y, 1) = -3.0f;
  for (const int iterations : {1, 2, 3, 5, 20}) {
    bench.iterations = iterations;
    const PassImages out = bench.run();
    for (int c = 0; c < 4; ++c) {
      CHECK(std::isfinite(out["landing"].at(0, 0, c)));
      CHECK(std::fabs(out["landing"].at(0, 0, c)) < 30.0f);
    }
  }
}

TEST_CASE("landing: the paper's estimator and Newton's begin where they are told") {
  // One step of the paper's from x0 looks up the floor below x0: sqrt(h^2 + (x0 sin)^2).
  LandingBench bench;
  bench.normal = tilted(30.0);
  bench.estimator = ESTIMATOR_PAPER;
  bench.receiver = bench.floor_map(1024, 0.0, 0.0);
  bench.iterations = 1;
  for (const float start : {0.0f, 1.0f, 3.0f}) {
    bench.search_start = start;
    const glm::vec4 p = texel(bench.run()["landing"], 0, 0);
    const double aside = double(start) * std::sin(0.183762);
    CHECK(std::hypot(double(p.x), 1.0 - double(p.y)) ==
          Approx(std::sqrt(1.0 + aside * aside)).margin(8.0 / 1024));
  }
}

TEST_CASE("landing: unguarded Newton jumps off where its difference straddles the root") {
  // Straight down onto a floor 1 m below: f = |x - 1|. With a difference of 1 m begun at 0.5 m, f(0.5) =
  // f(1.5), so the slope is 0 and there is no next place. Begun at 0 it is -1 and one step is exact.
  LandingBench bench;
  bench.estimator = ESTIMATOR_NEWTON;
  bench.newton_guard = false;
  bench.newton_epsilon = 1.0f;
  bench.iterations = 1;
  bench.draws_unconverged = true;
  CHECK(landing_status(bench.run()) == LandingStatus::Landed);
  bench.search_start = 0.5f;
  const PassImages out = bench.run();
  CHECK(landing_status(out) == LandingStatus::NotConverged);
  for (int c = 0; c < 3; ++c) CHECK(std::isfinite(out["landing"].at(0, 0, c)));
  bench.newton_guard = true;
  CHECK(landing_status(bench.run()) == LandingStatus::Landed);
}

TEST_CASE("landing: what has not converged is booked, or drawn where the search stopped") {
  // Bent by 45 degrees' tilt, one step from 0 ends at 1 m along the ray, more than two texels of 8 mm above
  // the floor: the ray leans 16.9 degrees, so 1 - cos = 0.043 m.
  LandingBench bench;
  bench.normal = tilted(45.0);
  bench.estimator = ESTIMATOR_PAPER;
  bench.receiver = bench.floor_map(1024, 0.0, 0.0);
  bench.iterations = 1;
  CHECK(landing_status(bench.run()) == LandingStatus::NotConverged);
  bench.draws_unconverged = true;
  const PassImages out = bench.run();
  CHECK(landing_status(out) == LandingStatus::Stopped);
  CHECK(texel(out["landing"], 0, 0).y == Approx(0.043).margin(2e-3));
}
