#include "tests/support/landing_bench.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("landing: a mirror sends light by the law of reflection and absorbs what its colour lacks") {
  // A steep mirror, its normal 60 degrees from up: light from above leaves along (sin 120, cos 120, 0) =
  // (0.8660254, -0.5, 0) and falls 1 m over 1.7320508 m.
  LandingBench bench;
  bench.mirror = true;
  bench.normal = tilted(60.0);
  const PassImages all = bench.run();
  CHECK(landing_status(all) == LandingStatus::Landed);
  CHECK(all["landing"].at(0, 0, 0) == Approx(1.7320508).epsilon(1e-4));
  CHECK(all["landing"].at(0, 0, 1) == Approx(0.0).margin(1e-4));
  CHECK(all["landing_flux"].at(0, 0, 0) == 0.25f);
  CHECK(all["landing_absorbed"].at(0, 0, 0) == 0.0f);
  // Copper's red and blue at cos 0.5: f + (1 - f) 0.5^5.
  bench.color = {0.95f, 0.64f, 0.54f};
  const PassImages copper = bench.run();
  CHECK(copper["landing_flux"].at(0, 0, 0) == Approx(0.25 * (0.95 + 0.05 / 32)));
  CHECK(copper["landing_flux"].at(0, 0, 2) == Approx(0.25 * (0.54 + 0.46 / 32)));
  CHECK(copper["landing_absorbed"].at(0, 0, 2) == Approx(0.25 * (0.46 - 0.46 / 32)));
  CHECK(copper["landing_fresnel"].at(0, 0, 2) == 0.0f);
}

TEST_CASE("landing: the back of a mirror's wall mirrors as its front does") {
  LandingBench bench;
  bench.mirror = true;
  bench.normal = -tilted(60.0);
  bench.facing = -1.0f;
  const PassImages out = bench.run();
  CHECK(landing_status(out) == LandingStatus::Landed);
  CHECK(out["landing"].at(0, 0, 0) == Approx(1.7320508).epsilon(1e-4));
}

TEST_CASE("landing: what a level mirror sends back towards the light lands nowhere") {
  LandingBench bench;
  bench.mirror = true;
  const LandingStatus where = landing_status(bench.run());
  CHECK((where == LandingStatus::Missed || where == LandingStatus::Outside ||
         where == LandingStatus::NotConverged));
}

TEST_CASE("landing: the reflected branch carries the Fresnel share along the mirrored ray") {
  // Normal 60 degrees towards +x: light is turned by 120 degrees and falls 30 degrees below the level, and
  // lands 1 / tan 30 = 1.7321 m to the right. R at 60 degrees for n = 1.5: ct = sqrt(1 - 0.75 / 2.25) =
  // 0.81650, Rs =
  // ((0.5 - 1.22474) / 1.72474)^2 = 0.176577, Rp = ((0.81650 - 0.75) / 1.56650)^2 = 0.001802, mean 0.089190.
  LandingBench bench;
  bench.normal = tilted(60.0);
  bench.reflected = true;
  const PassImages out = bench.run();
  REQUIRE(landing_status(out) == LandingStatus::Landed);
  CHECK(texel(out["landing"], 0, 0).x == Approx(1.73205).epsilon(1e-4));
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.089190).epsilon(1e-4));
  CHECK(out["landing_fresnel"].at(0, 0, 0) == 0.0f);
}

TEST_CASE("landing: metal has no reflected branch, its light is mirrored already") {
  LandingBench bench;
  bench.mirror = true;
  bench.reflected = true;
  CHECK(landing_status(bench.run()) == LandingStatus::Empty);
}

TEST_CASE("landing: a mirror's own colour at a grid vertex is its reflectance there") {
  // Light straight onto a mirror that leans by 45 degrees: Schlick's grazing share is (1 - cos 45)^5 =
  // 0.002155.
  LandingBench bench;
  bench.mirror = true;
  bench.color = {1.0f, 1.0f, 1.0f};
  bench.tint = glm::vec3(0.5f, 0.25f, 0.0f);
  bench.normal = tilted(45.0);
  const PassImages out = bench.run();
  const double grazing = std::pow(1.0 - std::sqrt(0.5), 5.0);
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * (0.5 + 0.5 * grazing)));
  CHECK(out["landing_flux"].at(0, 0, 2) == Approx(0.25 * grazing));
}
