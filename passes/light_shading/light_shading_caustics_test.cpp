// Light by caustics: what a surface takes of a light's maps.
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/light_shading_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

using Bench = LightShadingBench;

// A picture of 2 x 2 pixels, 4 m or 4 texels apart, on the floor under a map with light in one texel only.
// The pixel in the lower left has its middle at texel coordinates 2, 2.
PassImages run_wide_pixels(Bench bench, int bright_x, int bright_y, bool level = true) {
  bench.caustic_map = filled(8, 8, glm::vec4(0.0f));
  for (int c = 0; c < 3; ++c) bench.caustic_map.at(bright_x, bright_y, c) = 0.25f;
  Image position(Format::RGBA32F, 2, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x) {
      const glm::vec4 p{x == 0 ? -2.0f : 2.0f, !level && x == 1 ? 6.0f : 0.0f, y == 0 ? 2.0f : -2.0f, 1.0f};
      for (int c = 0; c < 4; ++c) position.at(x, y, c) = p[c];
    }
  const Pass pass = light_shading_pass();
  std::vector<Image> textures = bench.textures();
  textures[0] = position;
  textures[1] = filled(2, 2, {0.0f, 1.0f, 0.0f, 0.0f});
  return run_pass(definition_of(pass),
                  {.width = 2, .height = 2, .uniforms = bench.uniforms(pass), .textures = textures});
}

}  // namespace

TEST_CASE("light_shading: a caustic map of one channel lights every channel alike") {
  Bench bench = with_caustic();
  bench.light.color = {1.0f, 0.5f, 0.25f};
  const glm::vec4 three = texel(bench.run()["caustic"], 0, 0);
  Image grey(Format::R32F, 8, 8);
  for (float& value : grey.values) value = 0.25f;
  bench.caustic_map = grey;
  const glm::vec4 one = texel(bench.run()["caustic"], 0, 0);
  CHECK(one.x == three.x);
  CHECK(one == glm::vec4(three.x, 0.5f * three.x, 0.25f * three.x, 0.0f));
}

TEST_CASE("light_shading: a caustic is the texel's flux over its area, times the cosine") {
  // 8 m in 8 texels: 1 square metre each. 0.25 square metres' worth of 100 lux is 25 lumen.
  Bench bench = with_caustic();
  CHECK(texel(bench.run()["caustic"], 0, 0) == glm::vec4(25.0f, 50.0f, 0.0f, 0.0f));
  bench.normal = {std::sqrt(0.75f), 0.5f, 0.0f};
  CHECK(bench.caustic() == Approx(12.5));
  bench.normal = {0.0f, -1.0f, 0.0f};
  CHECK(bench.caustic() == 0.0f);
}

TEST_CASE("light_shading: a point light's caustic is spread over solid angle times distance squared") {
  // A window of tangents +-1 in 8 texels: 1/16 steradian at the axis, 6.25 square metres 10 m below.
  // 0.25 sr of 100 cd are 25 lumen.
  Bench bench = with_caustic();
  bench.light.type = LightType::Point;
  bench.light.position = {0.0, 10.0, 0.0};
  bench.position = {0.0f, 0.0f, 0.0f};
  CHECK(bench.caustic() == Approx(25.0 / 6.25));
  // 5 m aside, at tangent 0.5: solid angle / 1.25^1.5, distance squared 125, cosine 1 / sqrt(1.25). Area over
  // cosine is what it was: a level floor is cut into equal squares.
  bench.position = {5.0f, 0.0f, 0.0f};
  CHECK(bench.caustic() == Approx(25.0 / 6.25));
}

TEST_CASE("light_shading: only surfaces that the receiver map sees take the caustic") {
  Bench hidden = with_caustic();
  hidden.receiver = filled(8, 8, {0.0f, 5.0f, 0.0f, 1.0f});  // something 5 m above the floor
  CHECK(hidden.caustic() == 0.0f);
  Bench hole = with_caustic();
  hole.receiver = filled(8, 8, glm::vec4(0.0f));
  CHECK(hole.caustic() == 0.0f);
  Bench before = with_caustic();  // between light and casters: 10 m from the light, casters from 12 m on
  before.casters_nearest = 12.0;
  CHECK(before.caustic() == 0.0f);
  Bench outside = with_caustic();
  outside.position = {4.5f, 0.0f, 0.0f};
  CHECK(outside.caustic() == 0.0f);
}

TEST_CASE("light_shading: a light that throws no caustic neither reads nor is blocked by the casters") {
  Bench bench = with_caustic();
  bench.caster = filled(8, 8, {0.0f, 5.0f, 0.0f, 1.0f});
  bench.caustics = false;
  CHECK(bench.direct() == Approx(100.0));
  CHECK(bench.caustic() == 0.0f);
}

namespace {

// A map of 64 x 64 texels of 1/8 m, of which the cascade shows those within a metre of the middle, twice as
// much flux in each of its own texels.
Bench with_cascade() {
  Bench bench = with_caustic();
  bench.map = 64;
  bench.caustic_map = filled(64, 64, {0.25f, 0.5f, 0.0f, 1.0f});
  bench.cascade_map = filled(64, 64, {0.5f, 1.0f, 0.0f, 1.0f});
  return bench;
}

// 3.1 texels along each border are not shown: 57.8 of its texels stand for 16 of the map, and a hundredth of
// one on either side.
constexpr double kTexelsInOne = 57.8 / 16.02;

}  // namespace

TEST_CASE("light_shading: a cascade is taken where it reaches, in its own texels") {
  Bench bench = with_cascade();
  Bench without = bench;
  without.cascade_map = Image{};
  const auto finer_at = [&](float x, float z) {
    bench.position = without.position = {x, 0.0f, z};
    return static_cast<double>(bench.caustic() / without.caustic());
  };
  const double twice = 2.0 * kTexelsInOne * kTexelsInOne;
  CHECK(finer_at(0.05f, -0.05f) == Approx(twice));
  CHECK(finer_at(0.99f, -0.99f) == Approx(twice));
  CHECK(finer_at(1.01f, -0.99f) == Approx(1.0));
  CHECK(finer_at(0.99f, 1.01f) == Approx(1.0));
  for (Bench* b : {&bench, &without}) {
    b->light.type = LightType::Point;
    b->light.position = {0.0, 10.0, 0.0};
  }
  CHECK(finer_at(0.01f, -0.01f) == Approx(twice));
}

TEST_CASE("light_shading: beside a cascade none of the light is taken that it shows") {
  Bench bench = with_cascade();
  bench.position = {1.01f, 0.0f, 0.01f};
  const float even = bench.caustic();
  for (int y = 24; y < 40; ++y)
    for (int x = 24; x < 40; ++x) bench.caustic_map.at(x, y, 0) = 100.0f;
  CHECK(bench.caustic() == Approx(even));
  bench.position = {1.01f, 0.0f, 1.01f};
  CHECK(bench.caustic() == Approx(even));
  bench.cascade_map = Image{};
  CHECK(bench.caustic() > 2.0f * even);
}

TEST_CASE(
    "light_shading: a surface that another hides from the light takes the light of the farthest receivers") {
  Bench bench = with_caustic();
  const float open = bench.caustic();
  // The farthest receivers are a floor 5 m below; a texel's extent is a metre at most, of which two may lie
  // between.
  bench.far_receiver = filled(8, 8, {0.0f, -5.0f, 0.0f, 1.0f});
  bench.far_caustic_map = filled(8, 8, {0.125f, 0.25f, 0.0f, 1.0f});
  CHECK(bench.caustic() == open);
  bench.position.y = -5.0f;
  CHECK(bench.caustic() == 0.5f * open);
  // Between both, and below the farthest, lies nothing that the light was seen to reach.
  bench.position.y = -2.5f;
  CHECK(bench.caustic() == 0.0f);
  bench.position.y = -8.0f;
  CHECK(bench.caustic() == 0.0f);
  // Where the nearest receiver is the farthest, too, both maps hold a part of its light.
  bench.receiver = bench.far_receiver;
  bench.position.y = -5.0f;
  CHECK(bench.caustic() == 1.5f * open);
}

TEST_CASE("light_shading: a pixel wider than texels shows the mean of the caustic over itself") {
  // 4 texels: a spread of sqrt(16 - 1) = 3.873 texels, by 4 samples at 0.484 and 1.452 texels to either side.
  // A texel 1.5 from the middle has a share of 1 - (1.5 - 1.452) = 0.952 in one of them along each axis, and
  // none in the others. The view's y runs against the picture's here or along it, so all four pixels are
  // added up: one of them has the texel.
  const double share = (1.0 - (1.5 - 0.375 * std::sqrt(15.0))) / 4.0;
  const PassImages out = run_wide_pixels(with_caustic(), 0, 0);
  double sum = 0.0;
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x) sum += static_cast<double>(out["caustic"].at(x, y, 0));
  CHECK(sum == Approx(100.0 * 0.25 * share * share).epsilon(1e-5));
}

TEST_CASE("light_shading: a pixel's caustic is not averaged over what is no part of its surface") {
  // The pixels to the right lie 6 m higher: no step along the picture's x, so all samples keep the middle's
  // x, where a texel 1.5 away has no share.
  const PassImages out = run_wide_pixels(with_caustic(), 0, 0, false);
  for (int y = 0; y < 2; ++y) CHECK(out["caustic"].at(0, y, 0) == 0.0f);
}

TEST_CASE("light_shading: without pixel means a wide pixel shows its middle") {
  Bench bench = with_caustic();
  bench.pixel_means = false;
  const PassImages out = run_wide_pixels(bench, 0, 0);
  for (const float value : out["caustic"].values) CHECK(value == 0.0f);
}

TEST_CASE("light_shading: from behind a surface takes the light that the pilot says lands so, in its map") {
  Bench bench = with_caustic();
  bench.normal = {0.0f, -1.0f, 0.0f};
  CHECK(bench.caustic() == 0.0f);
  bench.behind = LitFromBehind::InNearest;
  CHECK(bench.caustic() == Approx(25.0));
  // The map shows something below: the point stands before it.
  bench.receiver = filled(8, 8, {0.0f, -5.0f, 0.0f, 1.0f});
  CHECK(bench.caustic() == 0.0f);
  bench.normal = {0.0f, 1.0f, 0.0f};
  CHECK(bench.caustic() == Approx(25.0));
  bench = with_caustic();
  bench.normal = {0.0f, -1.0f, 0.0f};
  bench.behind = LitFromBehind::InFarthest;
  CHECK(bench.caustic() == 0.0f);
  bench.far_receiver = filled(8, 8, {0.0f, 0.0f, 0.0f, 1.0f});
  bench.far_caustic_map = filled(8, 8, glm::vec4(0.5f));
  CHECK(bench.caustic() == Approx(50.0));
}
