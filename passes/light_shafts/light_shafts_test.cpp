#include "passes/light_shafts/light_shafts.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr double kPi = 3.14159265358979323846;

// A camera 10 m up that looks straight down on 8 x 8 pixels of 1 m. Pixel column 0 begins at x = -4, and row
// 0 at z = +4. A medium that scatters 0.1 per metre to all sides and takes nothing unless told to. Beams lie
// 5 m up.
struct Bench {
  View view = down(4.0, 10.0, 20.0);
  int side = 1;
  std::vector<glm::vec4> starts{{-2.5f, 5.0f, -0.5f, 4.0f}};  // length 4 along x, at the middle of row 4
  glm::vec4 way{1.0f, 0.0f, 0.0f, 1.0f};
  glm::vec4 flux{3.0f, 6.0f, 0.0f, 0.0f};
  glm::vec4 range{1e30f, 0.0f, 20.0f, 0.0f};
  float extinction = 0.0f, anisotropy = 0.0f;

  Image run() const {
    const std140::LightShafts u{.view = shader_view(view),
                                .picture = {8.0f, 8.0f},
                                .widest = 4.0f,
                                .pixel_area = static_cast<float>(view.window_area() / 64.0),
                                .intensity = glm::vec3(1.0f),
                                .beams_a_side = side,
                                .medium = {.lower = {-50.0f, 0.0f, -50.0f},
                                           .anisotropy = anisotropy,
                                           .upper = {50.0f, 20.0f, 50.0f},
                                           .is_grey = 1,
                                           .extinction = glm::vec3(extinction),
                                           .scattering = glm::vec3(0.1f)}};
    Image start = filled(side, side, glm::vec4(0.0f)), heading = start, carried = start;
    for (int i = 0; i < static_cast<int>(starts.size()); ++i)
      for (int c = 0; c < 4; ++c) {
        start.at(i % side, i / side, c) = starts[static_cast<std::size_t>(i)][c];
        heading.at(i % side, i / side, c) = way[c];
        carried.at(i % side, i / side, c) = flux[c];
      }
    return run_pass(definition_of(light_shafts_pass()),
                    {.width = 8,
                     .height = 8,
                     .uniforms = uniform_bytes(u),
                     .textures = {start, heading, carried, filled(8, 8, range)},
                     .vertex_count = 6 * side * side})["haze"];
  }
};

// Scattering times the phase function times the flux, of a metre of beam on a square metre.
constexpr double kUnit = 0.1 * 3.0 / (4.0 * kPi);

}  // namespace

TEST_CASE("light_shafts: a pixel gets scattering, phase, flux and length over its area") {
  // From column 1.5 to 5.5: half a metre in columns 1 and 5, a metre between. Alone a beam is a pixel wide
  // both ways: a triangle with a foot of +-1 pixel, of which 3/4 lie on the row of its middle and 1/8 on each
  // beside.
  const Image haze = Bench{}.run();
  CHECK(haze.at(3, 4, 0) == Approx(0.75 * kUnit));
  CHECK(haze.at(3, 4, 1) == Approx(1.5 * kUnit));
  CHECK(haze.at(3, 4, 2) == 0.0f);
  CHECK(haze.at(1, 4, 0) == Approx(0.375 * kUnit));
  CHECK(haze.at(5, 5, 0) == Approx(0.0625 * kUnit));
  CHECK(haze.at(0, 4, 0) == 0.0f);
  CHECK(haze.at(3, 6, 0) == 0.0f);
}

TEST_CASE("light_shafts: over all pixels the light is that of the whole length, whatever the slant") {
  for (const double turn : {0.0, 0.3, 0.785, 1.2, 1.5708, 2.5, 4.0, 5.9}) {
    for (const double fall : {0.0, 0.5, -0.8}) {
      Bench bench;
      const double across = std::sqrt(1.0 - fall * fall);
      bench.starts = {{0.13f, 5.0f, -0.21f, 2.7f}};
      bench.way = {static_cast<float>(across * std::cos(turn)), static_cast<float>(fall),
                   static_cast<float>(across * std::sin(turn)), 1.0f};
      CHECK(sum(bench.run()) == Approx(2.7 * kUnit).epsilon(1e-5));
    }
  }
}

TEST_CASE("light_shafts: a beam that runs along the camera's ray is a spot with all its light") {
  Bench bench;
  bench.starts = {{0.5f, 5.0f, -0.5f, 3.0f}};
  bench.way = {0.0f, -1.0f, 0.0f, 1.0f};
  const Image haze = bench.run();
  CHECK(sum(haze) == Approx(3.0 * kUnit));
  CHECK(haze.at(4, 4, 0) == Approx(3.0 * 0.75 * kUnit));
}

TEST_CASE("light_shafts: beams side by side make an even sheet") {
  // 2 x 2 beams, of which two exist, 3 m apart: each is 3 pixels wide one way and 1 the other. Between them
  // each row has a third of one beam's light.
  Bench bench;
  bench.side = 2;
  bench.starts = {{-2.5f, 5.0f, -1.5f, 4.0f}, {-2.5f, 5.0f, 1.5f, 4.0f}};
  const Image haze = bench.run();
  for (int row = 2; row <= 5; ++row) CHECK(haze.at(3, row, 0) == Approx(kUnit / 3.0));
  CHECK(sum(haze) == Approx(2.0 * 4.0 * kUnit).epsilon(1e-5));
}

TEST_CASE("light_shafts: what lies behind the first surface is hidden") {
  Bench behind;
  behind.range.x = 4.9f;
  CHECK(sum(behind.run()) == 0.0);
  // Down by 45 degrees from 5 m below the camera: half of it lies nearer than 6 m.
  Bench half;
  const float s = std::sqrt(0.5f);
  half.way = {s, -s, 0.0f, 1.0f};
  half.starts[0].w = 2.0f * std::sqrt(2.0f);
  half.range.x = 6.0f;
  CHECK(sum(half.run()) == Approx(std::sqrt(2.0) * kUnit).epsilon(1e-5));
}

TEST_CASE("light_shafts: the medium takes its share along the beam and on the way to the camera") {
  // 2 m of the camera's 5 lie before the medium. Column 3's middle is 2 m from the start.
  Bench bench;
  bench.extinction = 0.2f;
  bench.range.y = 2.0f;
  CHECK(bench.run().at(3, 4, 0) == Approx(0.75 * kUnit * std::exp(-0.2 * (2.0 + 3.0))));
}

TEST_CASE("light_shafts: forward scattering is bright towards the camera and dark away from it") {
  // Henyey and Greenstein at g = 0.5 against the even 1: (1 - g^2) / (1 + g^2 - 2 g cos)^1.5 is 6 ahead, 2/9
  // back.
  Bench bench;
  bench.anisotropy = 0.5f;
  bench.starts = {{0.5f, 2.0f, -0.5f, 3.0f}};
  bench.way = {0.0f, 1.0f, 0.0f, 1.0f};
  CHECK(sum(bench.run()) == Approx(3.0 * kUnit * 6.0));
  bench.starts = {{0.5f, 5.0f, -0.5f, 3.0f}};
  bench.way = {0.0f, -1.0f, 0.0f, 1.0f};
  CHECK(sum(bench.run()) == Approx(3.0 * kUnit * 2.0 / 9.0));
}

TEST_CASE("light_shafts: in a perspective picture a pixel's area grows with the distance") {
  // Pixels of tangent 0.1: 0.5 m wide 5 m below. The beam from x = -1 to 1 fills columns 2 to 5; a pixel's
  // area across its ray is 0.01 z^3 / d.
  Bench bench;
  bench.view = down(0.4, 10.0, 20.0);
  bench.view.perspective = true;
  bench.view.near = 0.1;
  bench.starts = {{-1.0f, 5.0f, -0.25f, 2.0f}};
  const Image haze = bench.run();
  for (int column = 2; column <= 5; ++column) {
    const double x = -1.0 + 0.5 * (column - 2 + 0.5), d = std::sqrt(25.0 + x * x + 0.0625);
    CHECK(haze.at(column, 4, 0) == Approx(0.75 * kUnit * 0.5 * d / (0.01 * 125.0)));
  }
  CHECK(haze.at(1, 4, 0) == 0.0f);
  // One that begins behind the camera is cut where the camera begins to see.
  Bench through = bench;
  through.starts = {{0.0f, 12.0f, 0.0f, 8.0f}};
  through.way = {0.0f, -1.0f, 0.0f, 1.0f};
  CHECK(std::isfinite(sum(through.run())));
}
