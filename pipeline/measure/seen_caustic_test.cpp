#include "pipeline/measure/seen_caustic.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// 64 x 32 pixels of 0.25 x 0.25 m of a floor, seen from straight above by parallel rays, in 3 lux of direct
// light; blocks are pixels.
struct Bench {
  View camera = down(8.0, 10.0, 20.0);
  Image position{Format::RGBA32F, 64, 32}, normal{Format::RGBA32F, 64, 32};
  Image caustic{Format::RGBA32F, 64, 32}, direct{Format::RGBA32F, 64, 32};
  Image caster{Format::RGBA32F, 64, 32};
  double ambient = 1.0;

  Bench() {
    camera.window_lower = {-8.0, -4.0};
    camera.window_upper = {8.0, 4.0};
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 64; ++x) {
        put(position, x, y, {0.0f, 0.0f, 0.0f, 1.0f});
        put(normal, x, y, {0.0f, 1.0f, 0.0f, 0.0f});
        put(direct, x, y, {3.0f, 3.0f, 3.0f, 0.0f});
      }
  }
  static void put(Image& image, int x, int y, const glm::vec4& value) {
    for (int c = 0; c < 4; ++c) image.at(x, y, c) = value[c];
  }
  SeenCaustic see() const {
    return see_caustic({position, normal, caustic, direct, caster}, camera, ambient);
  }
};

}  // namespace

TEST_CASE("seen caustic: its light is irradiance times the pixel's area, which a slant makes larger") {
  Bench bench;
  Bench::put(bench.caustic, 10, 3, {20.0f, 20.0f, 20.0f, 0.0f});
  CHECK(bench.see().beside == Approx(3 * 20.0 * 0.0625));
  Bench::put(bench.normal, 10, 3, {0.8660254f, 0.5f, 0.0f, 0.0f});
  CHECK(bench.see().beside == Approx(2 * 3 * 20.0 * 0.0625));
  CHECK(bench.see().through == 0.0);
}

TEST_CASE("seen caustic: a perspective pixel's surface is z^2 of the window's, over the cosine") {
  Bench bench;
  bench.camera.perspective = true;
  Bench::put(bench.caustic, 10, 3, {20.0f, 20.0f, 20.0f, 0.0f});
  // Straight below, 10 m.
  CHECK(bench.see().beside == Approx(3 * 20.0 * 0.0625 * 100.0));
}

TEST_CASE("seen caustic: the brightest pixel counts from the top left, against the brightest lit one near") {
  Bench bench;
  Bench::put(bench.caustic, 10, 3, {20.0f, 20.0f, 20.0f, 0.0f});
  Bench::put(bench.caustic, 50, 20, {5.0f, 5.0f, 5.0f, 0.0f});
  // It lies in a shadow; beside it 3 lux fall directly, far away 30.
  Bench::put(bench.direct, 10, 3, {0.0f, 0.0f, 0.0f, 0.0f});
  Bench::put(bench.direct, 60, 3, {30.0f, 30.0f, 30.0f, 0.0f});
  const SeenCaustic seen = bench.see();
  CHECK(seen.brightest == glm::dvec2(10.5, 32.0 - 3.5));
  CHECK(seen.times == Approx((20.0 + 1.0) / (3.0 + 1.0)));
  CHECK(seen.times_without == Approx((20.0 + 1.0) / 1.0));
}

TEST_CASE("seen caustic: what lies behind a caster is seen through it, and told where it is much brighter") {
  Bench bench;
  Bench::put(bench.caustic, 10, 3, {20.0f, 20.0f, 20.0f, 0.0f});
  Bench::put(bench.caster, 10, 3, {0.0f, 5.0f, 0.0f, -1.0f});
  Bench::put(bench.caustic, 30, 3, {10.0f, 10.0f, 10.0f, 0.0f});
  CHECK(bench.see().through == Approx(3 * 20.0 * 0.0625));
  CHECK(bench.see().beside == Approx(3 * 10.0 * 0.0625));
  CHECK_FALSE(bench.see().is_through);
  CHECK(bench.see().brightest.x == 30.5);
  Bench::put(bench.caustic, 30, 3, {6.0f, 6.0f, 6.0f, 0.0f});
  CHECK(bench.see().is_through);
  CHECK(bench.see().brightest.x == 10.5);
  // A caster below the floor hides nothing.
  Bench::put(bench.caster, 10, 3, {0.0f, -5.0f, 0.0f, 1.0f});
  CHECK(bench.see().through == 0.0);
}

TEST_CASE("seen caustic: nothing is told where nothing is seen, nor how bright where nothing else is lit") {
  Bench bench;
  CHECK(bench.see().beside == 0.0);
  CHECK(bench.see().times == 0.0);
  Bench::put(bench.caustic, 10, 3, {20.0f, 20.0f, 20.0f, 0.0f});
  bench.direct = Image(Format::RGBA32F, 64, 32);
  CHECK(bench.see().beside > 0.0);
  CHECK(bench.see().times == 0.0);
}

TEST_CASE("seen caustic: the brightest place lies in the picture where blocks reach beyond its edges") {
  // Blocks of 2 x 2: of 65 x 33 pixels the last column and row fill half of theirs.
  const auto filled_with = [](const glm::vec4& value) {
    Image image(Format::RGBA32F, 65, 33);
    for (int y = 0; y < 33; ++y)
      for (int x = 0; x < 65; ++x) Bench::put(image, x, y, value);
    return image;
  };
  const Image position = filled_with({0.0f, 0.0f, 0.0f, 1.0f}),
              normal = filled_with({0.0f, 1.0f, 0.0f, 0.0f});
  Image caustic = filled_with(glm::vec4(0.0f));
  Bench::put(caustic, 64, 32, glm::vec4(20.0f));
  const Bench bench;
  const SeenCaustic seen = see_caustic({position, normal, caustic, caustic, {}}, bench.camera, 1.0);
  CHECK(seen.brightest == glm::dvec2(64.5, 0.5));
}
