#include "tests/support/landing_bench.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A level floor's distance along d from a point at this height.
double to_floor(const glm::dvec3& d, double height) { return d.y < 0.0 ? height / -d.y : 0.0; }

// How far from (0, 1, 0) the light has landed.
double flown(const PassImages& out) {
  return glm::length(glm::dvec3(glm::vec3(texel(out["landing"], 0, 0))) - glm::dvec3(0.0, 1.0, 0.0));
}

// A mirror at (0, 1, 0) that sends the light from above along (-0.6, -0.8, 0), and impostors to find it by.
LandingBench impostor_bench(const glm::dvec3& centre,
                            const std::function<double(const glm::dvec3&)>& distance, int side = 600) {
  LandingBench bench;
  bench.mirror = true;
  bench.normal = {-0.948683298f, 0.316227766f, 0.0f};
  bench.estimator = ESTIMATOR_IMPOSTOR;
  bench.impostors = with_atlas(cube_view(centre, {1.0, 20.0}), side);
  bench.impostor = positions_around(bench.impostors, distance);
  return bench;
}

}  // namespace

TEST_CASE("landing: distance impostors meet a plane by the paper's start alone") {
  // The start d0 = D(R) (1 - |p| / D(p)) is exact on a plane; one step more must leave it there. 1 m down at
  // 0.8 a metre: 1.25 m.
  LandingBench bench = impostor_bench({0.0, 2.0, 0.0}, [](const glm::dvec3& d) { return to_floor(d, 2.0); });
  bench.iterations = 1;
  const PassImages out = bench.run();
  CHECK(landing_status(out) == LandingStatus::Landed);
  CHECK(flown(out) == Approx(1.25).epsilon(1e-5));
  CHECK(out["landing_flux"].at(0, 0, 3) < 1e-5f);
}

TEST_CASE("landing: distance impostors that fall short go on by the ray's own distance") {
  // A sphere of 1 m whose centre lies 0.5 m beside the ray: q = sqrt(0.25 + d^2). d0 = 1 - 0.5, q0 =
  // 0.707107; d1 = 0.5 + (1 - q0) = 0.792893, q1 = 0.937379; d2 = 0.855514, q2 = 0.990920; d3 = 0.864595.
  LandingBench bench = impostor_bench(
      {-0.4, 1.3, 0.0}, [](const glm::dvec3& d) { return 1.0 / glm::length(d); }, 2400);
  const double steps[] = {0.792893, 0.855514, 0.864595};
  for (int k = 1; k <= 3; ++k) {
    bench.iterations = k;
    CHECK(flown(bench.run()) == Approx(steps[k - 1]).epsilon(2e-5));
  }
  // The exact distance is 0.866025; after one step a gap of 63 mm is left, which is not taken for a landing.
  bench.iterations = 1;
  CHECK(landing_status(bench.run()) == LandingStatus::NotConverged);
  bench.iterations = 8;
  CHECK(landing_status(bench.run()) == LandingStatus::Landed);
  CHECK(flown(bench.run()) == Approx(0.866025).epsilon(1e-4));
}

TEST_CASE("landing: distance impostors that go too far come back by the secant") {
  // The middle is 1 m above the mirror. Along the ray's direction it sees into a pit of 10 m below: D(R)
  // = 12.5 and d0 = 12.5 (1 - 1 / 2) = 6.25, where l = (-3.75, -6) points at the floor: q = 6 / 2 = 3, too
  // far. From q = 0.5 at 0 the secant gives 6.25 (1 - 0.5) / (3 - 0.5) = 1.25, which is the floor.
  LandingBench bench = impostor_bench({0.0, 2.0, 0.0}, [](const glm::dvec3& d) {
    const bool pit = d.y < 0.0 && d.x < 0.65 * d.y;
    return to_floor(d, pit ? 10.0 : 2.0);
  });
  bench.iterations = 1;
  const PassImages out = bench.run();
  CHECK(flown(out) == Approx(1.25).epsilon(1e-5));
  CHECK(landing_status(out) == LandingStatus::Landed);
}

TEST_CASE("landing: distance impostors see all of a box room, over the cube's edges too") {
  // A room of 4 x 3 x 4 m. Mirrors turned many ways send the light at every wall, past edges and corners of
  // the cube; it must land on a wall, and in the ray's direction.
  const glm::dvec3 middle{0.3, 1.4, -0.2};
  const auto walls = [&](const glm::dvec3& from, const glm::dvec3& d) {
    double t = 1e30;
    const double lower[3] = {-2.0, 0.0, -2.0}, upper[3] = {2.0, 3.0, 2.0};
    for (int a = 0; a < 3; ++a)
      if (d[a] != 0.0) t = std::min(t, ((d[a] > 0.0 ? upper[a] : lower[a]) - from[a]) / d[a]);
    return t;
  };
  LandingBench bench = impostor_bench(middle, [&](const glm::dvec3& d) { return walls(middle, d); });
  bench.iterations = 12;
  bench.view = down(8.0, 10.0, 20.0);
  int landed = 0;
  for (int turn = 0; turn < 40; ++turn)
    for (const double lean : {0.15, 0.5, 0.7, 0.95, 1.2}) {
      const double a = 0.157 * turn;
      const glm::dvec3 n{std::sin(lean) * std::cos(a), std::cos(lean), std::sin(lean) * std::sin(a)};
      bench.normal = glm::vec3(n);
      const PassImages out = bench.run();
      // The light falls along -y: r = d - 2 (d.n) n.
      const glm::dvec3 r = glm::dvec3(0.0, -1.0, 0.0) + 2.0 * n.y * n;
      if (landing_status(out) != LandingStatus::Landed) continue;
      ++landed;
      CHECK(flown(out) == Approx(walls({0.0, 1.0, 0.0}, r)).epsilon(0.01));
    }
  CHECK(landed == 200);
}

TEST_CASE("landing: distance impostors without a surface book what is missed") {
  LandingBench bench = impostor_bench({0.0, 2.0, 0.0}, [](const glm::dvec3&) { return 0.0; });
  CHECK(landing_status(bench.run()) == LandingStatus::Missed);
  // From the very middle of the cube, where the start has no direction.
  bench = impostor_bench({0.0, 1.0, 0.0}, [](const glm::dvec3& d) { return to_floor(d, 1.0); });
  CHECK(flown(bench.run()) == Approx(1.25).epsilon(1e-5));
}
