#include "pipeline/measure/pixel_side.hpp"

#include <cmath>

#include "pipeline/scene/cube_view.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// 4 x 4 pixels, 2 m apart, of a floor under a map of 8 x 8 texels of 1 m.
struct Bench {
  View view = down(4.0, 10.0, 20.0);
  Image map = filled(8, 8, glm::vec4(1.0f));
  Image position{Format::RGBA32F, 4, 4};

  Bench() {
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) put(x, y, {-3.0f + 2.0f * float(x), 0.0f, 3.0f - 2.0f * float(y)});
  }
  void put(int x, int y, const glm::vec3& p) {
    for (int c = 0; c < 3; ++c) position.at(x, y, c) = p[c];
    position.at(x, y, 3) = 1.0f;
  }
  double side() const { return pixel_side(position, map, view); }
};

}  // namespace

TEST_CASE("pixel side: pixels of 2 m on texels of 1 m") { CHECK(Bench().side() == Approx(2.0)); }

TEST_CASE("pixel side: only what shows light counts") {
  Bench bench;
  bench.map = filled(8, 8, glm::vec4(0.0f));
  CHECK(bench.side() == 0.0);
  // Texel 1 holds the light, and the pixel at -3 m, whose neighbour is moved to 1 m from it: 1 m by 2 m.
  bench.map.at(1, 1, 0) = 1.0f;
  for (int y = 0; y < 4; ++y) bench.put(1, y, {-2.0f, 0.0f, 3.0f - 2.0f * float(y)});
  CHECK(bench.side() == Approx(std::sqrt(2.0)));
}

TEST_CASE("pixel side: a neighbour far behind does not make a pixel large") {
  // The rightmost column shows something 1 km away, or 6 m: the pixels beside it are measured by their other
  // neighbours.
  Bench bench;
  for (const float away : {500.0f, 7.0f}) {
    for (int y = 0; y < 4; ++y)
      bench.put(3, y, {away, away == 7.0f ? 0.0f : -1000.0f, 3.0f - 2.0f * float(y)});
    CHECK(bench.side() == Approx(2.0));
  }
}

TEST_CASE("pixel side: under a light that sees all around, texels are those of the face below it") {
  // A face of the atlas' 96 texels is (96 / 3 - 2 guard) wide and (96 / 2 - 2 guard) high over 2 tangents: 20
  // m on the floor, 10 m below. Pixels of 2 m.
  Bench bench;
  bench.view = with_atlas(cube_view({0.0, 10.0, 0.0}, {0.1, 20.0}), 96);
  bench.map = filled(96, 96, glm::vec4(1.0f));
  const CubeAtlas& atlas = *bench.view.cube;
  const double texels = 2.0 / 20.0 * std::sqrt(double(atlas.face_width()) * double(atlas.face_height()));
  CHECK(bench.side() == Approx(texels));
}

TEST_CASE("pixel side: none where a pixel has no neighbours") {
  Bench bench;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x)
      if (x != 1 || y != 1) bench.position.at(x, y, 3) = 0.0f;
  CHECK(bench.side() == 0.0);
}
