#include "passes/landing/landing.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/landing_bench.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("landing: through a level surface light falls straight and loses its Fresnel share") {
  // R0 = ((1.5 - 1) / (1.5 + 1))^2 = 0.04.
  const PassImages out = LandingBench{}.run();
  REQUIRE(landing_status(out) == LandingStatus::Landed);
  const glm::vec4 p = texel(out["landing"], 0, 0);
  CHECK(p.x == 0.0f);
  CHECK(p.y == Approx(0.0).margin(1e-5));
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.96));
  CHECK(out["landing_fresnel"].at(0, 0, 1) == Approx(0.25 * 0.04));
  CHECK(out["landing_fresnel"].at(0, 0, 3) == 0.25f);
}

TEST_CASE("landing: a tilted surface bends light by Snell's law") {
  // Incidence 30 degrees: sin t = 0.5 / 1.5, t = 19.4712 degrees; the ray leans 10.5288 degrees away
  // from the vertical, against the tilt, and falls 1 m: x = -tan 10.5288 degrees.
  LandingBench bench;
  bench.normal = tilted(30.0);
  const PassImages out = bench.run();
  REQUIRE(landing_status(out) == LandingStatus::Landed);
  CHECK(out["landing"].at(0, 0, 0) == Approx(-std::tan(0.183762)).epsilon(1e-4));
}

TEST_CASE("landing: an index of 1 bends nothing and loses nothing") {
  LandingBench bench;
  bench.ior = 1.0f;
  bench.normal = tilted(60.0);
  const PassImages out = bench.run();
  CHECK(out["landing"].at(0, 0, 0) == 0.0f);
  CHECK(out["landing_flux"].at(0, 0, 2) == 0.25f);
}

TEST_CASE("landing: a slab of two parallel surfaces leaves the direction as it was") {
  LandingBench bench;
  bench.solid = true;
  const PassImages out = bench.run();
  REQUIRE(landing_status(out) == LandingStatus::Landed);
  CHECK(out["landing"].at(0, 0, 0) == 0.0f);
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.96 * 0.96));
  CHECK(out["landing_absorbed"].at(0, 0, 3) == Approx(0.5));
}

TEST_CASE("landing: a solid absorbs by Beer and Lambert along the path inside, per channel") {
  LandingBench bench;
  bench.solid = true;
  bench.absorption = {0.0f, 1.0f, 4.0f};
  const PassImages out = bench.run();
  const double in = 0.25 * 0.96;
  CHECK(out["landing_absorbed"].at(0, 0, 0) == Approx(0.0).margin(1e-9));
  CHECK(out["landing_absorbed"].at(0, 0, 1) == Approx(in * (1.0 - std::exp(-0.5))));
  CHECK(out["landing_absorbed"].at(0, 0, 2) == Approx(in * (1.0 - std::exp(-2.0))));
  CHECK(out["landing_flux"].at(0, 0, 2) == Approx(in * std::exp(-2.0) * 0.96));
  CHECK(landing_status(out) == LandingStatus::Landed);
  bench.absorption = glm::vec3(40.0f);  // exp(-20) is less than a millionth
  CHECK(landing_status(bench.run()) == LandingStatus::Absorbed);
}

TEST_CASE("landing: under an open surface the medium absorbs down to the receiver") {
  LandingBench bench;
  bench.absorption = {1.0f, 0.0f, 0.0f};
  CHECK(bench.run()["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.96 * std::exp(-1.0)));
}

TEST_CASE("landing: beyond the critical angle nothing leaves and the flux is booked") {
  // asin(1 / 1.5) = 41.81 degrees: an exit surface leaning 45 degrees reflects all.
  LandingBench bench;
  bench.solid = true;
  bench.exit_normal = -tilted(45.0);
  const PassImages out = bench.run();
  CHECK(landing_status(out) == LandingStatus::TotalReflection);
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.96));
  // Whatever it would have met later.
  LandingBench nowhere = bench;
  nowhere.receiver = Image(Format::RGBA32F, 8, 8);
  CHECK(landing_status(nowhere.run()) == LandingStatus::TotalReflection);
  bench.exit_normal = -tilted(41.0);
  CHECK(landing_status(bench.run()) == LandingStatus::Landed);
}

TEST_CASE("landing: where no exit is met nothing is totally reflected, nor does anything land") {
  LandingBench bench;
  bench.solid = true;
  bench.exit_seen = false;
  CHECK(landing_status(bench.run()) == LandingStatus::ExitNotFound);
  bench.exit_normal = -tilted(45.0);
  CHECK(landing_status(bench.run()) == LandingStatus::ExitNotFound);
}

TEST_CASE("landing: over a hole light flies on to a floor that begins just before its landing") {
  // It leans away by 10.5288 degrees, as above, and lands at x = -0.18585; the floor begins at -11 / 64 m.
  LandingBench bench;
  bench.normal = tilted(30.0);
  bench.receiver = bench.floor_map(512, 0.0, 0.0);
  for (int y = 0; y < 512; ++y)
    for (int x = 256 - 11; x < 512; ++x)
      for (int c = 0; c < 4; ++c) bench.receiver.at(x, y, c) = 0.0f;
  const PassImages out = bench.run();
  REQUIRE(landing_status(out) == LandingStatus::Landed);
  CHECK(out["landing"].at(0, 0, 0) == Approx(-std::tan(0.183762)).epsilon(1e-4));
}

TEST_CASE("landing: at a crease light leaves by one of its faces, not by what lies between") {
  // A roof's two faces lean by 30 degrees; the vertex lies above the ridge. Snell: asin(1.5 sin 30) = 48.59,
  // so light leaves 18.59 degrees off the vertical, half a metre above the floor, and by no means straight
  // down.
  LandingBench bench;
  bench.solid = true;
  bench.exit_normal = -tilted(30.0);
  bench.exit_normal_left = -tilted(-30.0);
  CHECK(std::fabs(bench.run()["landing"].at(0, 0, 0)) == Approx(0.5 * std::tan(0.32446)).epsilon(1e-3));
}

TEST_CASE("landing: every vertex's flux is accounted for to rounding") {
  LandingBench bench;
  bench.solid = true;
  bench.absorption = {0.5f, 1.0f, 2.0f};
  bench.exit_normal = -tilted(20.0);
  const PassImages out = bench.run();
  for (int c = 0; c < 3; ++c)
    CHECK(double(out["landing_flux"].at(0, 0, c)) + double(out["landing_fresnel"].at(0, 0, c)) +
              double(out["landing_absorbed"].at(0, 0, c)) ==
          Approx(0.25).epsilon(1e-6));
}

TEST_CASE("landing: light that meets no receiver is missed, light that leaves the map is outside") {
  LandingBench bench;
  bench.receiver = Image(Format::RGBA32F, 8, 8);
  CHECK(landing_status(bench.run()) == LandingStatus::Missed);
  bench.receiver = bench.floor_map(64, 0.0, 0.0);
  bench.normal = tilted(85.0);
  bench.ior = 3.0f;
  bench.view.window_lower = glm::dvec2(-0.2);
  bench.view.window_upper = glm::dvec2(0.2);
  CHECK(landing_status(bench.run()) == LandingStatus::Outside);
  // Where the floor ends inside the window, the same ray passes it.
  bench.receivers_lower = {-0.2f, 0.0f, -0.2f};
  bench.receivers_upper = {0.2f, 0.0f, 0.2f};
  CHECK(landing_status(bench.run()) == LandingStatus::Missed);
}

TEST_CASE("landing: of light that leaves the map, only what goes towards the receivers' box is outside") {
  // A mirror turned by 45 degrees sends the light to -x or +x along y = 1; the map sees 0.2 m around.
  LandingBench bench;
  bench.mirror = true;
  bench.normal = tilted(45.0);
  bench.view.window_lower = glm::dvec2(-0.2);
  bench.view.window_upper = glm::dvec2(0.2);
  const auto wall_at = [&](float x) {
    bench.receivers_lower = {x, 0.0f, -1.0f};
    bench.receivers_upper = {x, 2.0f, 1.0f};
    return landing_status(bench.run());
  };
  const float side = wall_at(5.0f) == LandingStatus::Outside ? 1.0f : -1.0f;
  CHECK(wall_at(5.0f * side) == LandingStatus::Outside);
  CHECK(wall_at(-5.0f * side) == LandingStatus::Missed);
}

TEST_CASE("landing: the paper's weight is N.L and ignores Fresnel") {
  LandingBench bench;
  bench.paper_weights = true;
  bench.normal = tilted(60.0);
  const PassImages out = bench.run();
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.125));
  CHECK(out["landing_fresnel"].at(0, 0, 0) == 0.0f);
}

TEST_CASE("landing: the paper's weight is an equal part of the light, whatever falls on the cell") {
  // 10 vertices have the light of 6 cells of 0.25 square metres: 0.15 each, times the cosine of 30 degrees.
  LandingBench bench;
  bench.normal = tilted(30.0);
  bench.paper_weights = true;
  bench.caster_flux = {6.0f, 10.0f};
  CHECK(bench.run()["landing_fresnel"].at(0, 0, 3) == Approx(0.15 * std::sqrt(0.75)).epsilon(1e-5));
}

TEST_CASE("landing: a texel without a caster writes zeros") {
  LandingBench bench;
  bench.facing = 0.0f;
  const PassImages out = bench.run();
  CHECK(texel(out["landing"], 0, 0) == glm::vec4(0.0f));
  CHECK(texel(out["landing_flux"], 1, 1) == glm::vec4(0.0f));
}

TEST_CASE("landing: a point light's cell subtends its solid angle") {
  // A cell of 0.25 tangent units squared on the axis: 0.25 sr by the midpoint form.
  LandingBench bench;
  bench.view.perspective = true;
  bench.view.near = 0.1;
  const PassImages out = bench.run();
  CHECK(out["landing_fresnel"].at(0, 0, 3) == Approx(0.25));
  // 45 degrees off the axis it is by the cube of the cosine smaller.
  bench.view.origin.x = -9.0;
  CHECK(bench.run()["landing_fresnel"].at(0, 0, 3) == Approx(0.25 * std::pow(0.5, 1.5)));
}

TEST_CASE("landing: light that meets a surface from inside leaves by Snell's law") {
  // A back face leaning by 20 degrees: outside asin(1.5 sin 20) = 30.866 degrees, so 10.866 off the vertical,
  // from 1 m above the floor. R from inside is 0.041729.
  LandingBench bench;
  bench.facing = -1.0f;
  bench.normal = -tilted(-20.0);
  const PassImages out = bench.run();
  CHECK(out["landing"].at(0, 0, 0) == Approx(-std::tan(10.866 * 3.14159265 / 180.0)).epsilon(1e-4));
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * (1.0 - 0.041729)).epsilon(1e-5));
}

TEST_CASE("landing: the index is n_d and the branch's bend of n_F - n_C") {
  // Index 1.5 + 2 * 0.05 = 1.6 at 30 degrees: t = asin(0.5 / 1.6) = 18.2099 degrees, x = -tan(30 - 18.2099).
  LandingBench bench;
  bench.normal = tilted(30.0);
  bench.dispersion = 0.05f;
  bench.channel_share = {0.25f, 0.5f, 0.0f};
  bench.bend = 2.0f;
  const PassImages out = bench.run();
  CHECK(texel(out["landing"], 0, 0).x == Approx(-0.208716).epsilon(1e-4));
  // Each channel carries its share of the branch's flux; what entered stays whole.
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.5 * out["landing_flux"].at(0, 0, 1)));
  CHECK(out["landing_flux"].at(0, 0, 2) == 0.0f);
  CHECK(out["landing_fresnel"].at(0, 0, 3) == 0.25f);
}

TEST_CASE("landing: the base colour tints what glass lets through") {
  LandingBench bench;
  bench.color = {1.0f, 0.5f, 0.25f};
  const PassImages out = bench.run();
  CHECK(out["landing_flux"].at(0, 0, 1) == Approx(0.25 * 0.96 * 0.5));
  CHECK(out["landing_absorbed"].at(0, 0, 2) == Approx(0.25 * 0.96 * 0.75));
}

TEST_CASE("landing: of what is not mirrored a share is let through, and the rest booked as absorbed") {
  LandingBench bench;
  bench.color = {1.0f, 0.5f, 0.25f};
  bench.transmitted = 0.6f;
  const PassImages out = bench.run();
  CHECK(out["landing_flux"].at(0, 0, 1) == Approx(0.25 * 0.96 * 0.5 * 0.6));
  CHECK(out["landing_absorbed"].at(0, 0, 0) == Approx(0.25 * 0.96 * 0.4));
}

TEST_CASE("landing: Wyman's thickness is the mean of two, by the angles") {
  // Exit plane 0.5 m below the entry point: d_V = 0.5 straight down. Normal tilted by 30 degrees: d_N = 0.5 /
  // cos 30 = 0.577350; incidence 30, refraction 19.4712 degrees: 0.649040 * 0.5 + 0.350960 * 0.577350 =
  // 0.527147.
  LandingBench bench;
  bench.normal = tilted(30.0);
  bench.solid = true;
  bench.wyman = true;
  CHECK(bench.run()["landing_absorbed"].at(0, 0, 3) == Approx(0.527147).epsilon(1e-5));
  // Straight on, the two are one.
  bench.normal = tilted(0.0);
  CHECK(bench.run()["landing_absorbed"].at(0, 0, 3) == Approx(0.5).epsilon(1e-6));
}

TEST_CASE("landing: a grid vertex's own colour takes the place of its material's, once for both surfaces") {
  // 0.96 is left at either surface of the slab.
  LandingBench bench;
  bench.solid = true;
  bench.color = {0.1f, 0.1f, 0.1f};
  bench.tint = glm::vec3(0.5f, 1.0f, 0.0f);
  const PassImages out = bench.run();
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.96 * 0.96 * 0.5));
  CHECK(out["landing_flux"].at(0, 0, 1) == Approx(0.25 * 0.96 * 0.96));
  CHECK(out["landing_flux"].at(0, 0, 2) == 0.0f);
  CHECK(out["landing_absorbed"].at(0, 0, 2) == Approx(0.25 * 0.96));
}

TEST_CASE("landing: a wall without thickness lets light straight through, tinted") {
  // At incidence of 0 each face mirrors 0.04, both 2 r / (1 + r) = 0.0769231; the colour counts once.
  LandingBench bench;
  bench.thin = true;
  bench.color = {1.0f, 0.5f, 1.0f};
  const PassImages straight = bench.run();
  REQUIRE(landing_status(straight) == LandingStatus::Landed);
  CHECK(straight["landing"].at(0, 0, 0) == Approx(0.0).margin(1e-6));
  CHECK(straight["landing_flux"].at(0, 0, 0) == Approx(0.25 * 0.923077));
  CHECK(straight["landing_flux"].at(0, 0, 1) == Approx(0.25 * 0.923077 * 0.5));
}

TEST_CASE("landing: a closed body of walls tints and mirrors at both, and bends nothing") {
  LandingBench bench;
  bench.thin = bench.solid = true;
  bench.color = {1.0f, 0.5f, 1.0f};
  bench.normal = tilted(30.0);
  const PassImages out = bench.run();
  REQUIRE(landing_status(out) == LandingStatus::Landed);
  CHECK(out["landing"].at(0, 0, 0) == Approx(0.0).margin(1e-5));
  // The upper wall is met at 30 degrees: r = 0.041523, (1 - r) / (1 + r) = 0.920265; the lower straight on.
  const double flux = 0.25 * 0.920265 * 0.923077;
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(flux).epsilon(1e-4));
  CHECK(out["landing_flux"].at(0, 0, 1) == Approx(flux * 0.25).epsilon(1e-4));
}
