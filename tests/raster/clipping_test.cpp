// Clipping at the six planes of the view volume (OpenGL 4.5, 13.5), and what is not finite.
#include <cmath>
#include <limits>

#include "tests/raster/raster_bench.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

RasterVertex clip(float x, float y, float z, float w, float value = 1.0f) {
  RasterVertex v;
  v.x = x;
  v.y = y;
  v.z = z;
  v.w = w;
  v.red = value;
  return v;
}

// A square of +-half in clip coordinates at depth z.
std::vector<RasterVertex> square(float half, float z, float w = 1.0f) {
  return {clip(-half, -half, z, w), clip(half, -half, z, w), clip(half, half, z, w),
          clip(-half, -half, z, w), clip(half, half, z, w),  clip(-half, half, z, w)};
}

}  // namespace

TEST_CASE("clipping: what reaches far beyond the sides covers the target once") {
  for (const float half : {1.9f, 6.0f, 100.0f, 1e6f}) {
    RasterBench b = counting(16, 16);
    const Image image = b.draw(square(half, 0.5f))[0];
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) CHECK(image.at(x, y, 0) == 1.0f);
  }
}

TEST_CASE("clipping: two planes leave a polygon of five corners") {
  // All of 8 x 8 pixels but the upper right one lie below x + y = 14.2.
  RasterBench b = counting(8, 8);
  const Image image = b.draw({b.at(0, 0), b.at(14.2, 0), b.at(0, 14.2)})[0];
  CHECK(RasterBench::sum(image) == 63.0);
  CHECK(image.at(7, 7, 0) == 0.0f);
}

TEST_CASE("clipping: nothing before the near plane or behind the far plane is drawn") {
  RasterBench b = counting(8, 8);
  CHECK(RasterBench::sum(b.draw(square(1.0f, -0.001f))[0]) == 0.0);
  CHECK(RasterBench::sum(b.draw(square(1.0f, 1.001f))[0]) == 0.0);
  CHECK(RasterBench::sum(b.draw(square(1.0f, 0.0f))[0]) == 64.0);
  CHECK(RasterBench::sum(b.draw(square(1.0f, 1.0f))[0]) == 64.0);
}

TEST_CASE("clipping: each plane cuts a triangle in the middle") {
  // A square from -1 to 1 with one coordinate shifted so that exactly half of it lies inside.
  struct Cut {
    float dx, dy, z_left, z_right;
  };
  for (const Cut& cut :
       {Cut{1.0f, 0.0f, 0.5f, 0.5f}, Cut{-1.0f, 0.0f, 0.5f, 0.5f}, Cut{0.0f, 1.0f, 0.5f, 0.5f},
        Cut{0.0f, -1.0f, 0.5f, 0.5f}, Cut{0.0f, 0.0f, -0.5f, 0.5f}, Cut{0.0f, 0.0f, 0.5f, 1.5f}}) {
    RasterBench b = counting(16, 16);
    const auto at = [&](float x, float y) {
      return clip(x + cut.dx, y + cut.dy, x < 0.0f ? cut.z_left : cut.z_right, 1.0f);
    };
    const Image image = b.draw({at(-1, -1), at(1, -1), at(1, 1), at(-1, -1), at(1, 1), at(-1, 1)})[0];
    CHECK(RasterBench::sum(image) == 128.0);
  }
}

TEST_CASE("clipping: a triangle through the eye's plane is cut before it divides by w") {
  // A floor y = -1 that starts behind the eye (w = -1) and ends far in front (w = 9): it covers the lower
  // half up to its horizon and nothing above.
  RasterBench b = counting(32, 32);
  const auto at = [](float x, float w) { return clip(x, -1.0f, 0.1f * w, w); };
  const Image image = b.draw({at(-40, -1), at(40, -1), at(40, 9), at(-40, -1), at(40, 9), at(-40, 9)})[0];
  CHECK(image.at(16, 0, 0) == 1.0f);
  CHECK(image.at(16, 13, 0) == 1.0f);  // y = -1 / 9 maps to row 14.2
  CHECK(image.at(16, 15, 0) == 0.0f);
  CHECK(image.at(16, 31, 0) == 0.0f);
  for (const float value : image.values) CHECK((value == 0.0f || value == 1.0f));
}

TEST_CASE("clipping: attributes at a cut are those of the uncut triangle") {
  // Red is 0 at x = -3 and 1 at x = 3 (clip), so it is (x + 3) / 6 everywhere inside.
  RasterBench b;
  b.width = b.height = 16;
  const Image image =
      b.draw({clip(-3, -3, 0.5f, 1, 0.0f), clip(3, -3, 0.5f, 1, 1.0f), clip(3, 3, 0.5f, 1, 1.0f),
              clip(-3, -3, 0.5f, 1, 0.0f), clip(3, 3, 0.5f, 1, 1.0f), clip(-3, 3, 0.5f, 1, 0.0f)})[0];
  for (int x = 0; x < 16; ++x) {
    const double ndc = (x + 0.5) / 8.0 - 1.0;
    CHECK(image.at(x, 5, 0) == Approx((ndc + 3.0) / 6.0).epsilon(1e-6));
  }
}

TEST_CASE("clipping: positions that are not finite draw nothing and hurt nobody") {
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, infinity, -infinity})
    for (int component = 0; component < 4; ++component) {
      RasterBench b = counting(8, 8);
      std::vector<RasterVertex> v = square(1.0f, 0.5f);
      if (component == 3 && bad == infinity) continue;  // the next test
      (component == 0 ? v[0].x : component == 1 ? v[0].y : component == 2 ? v[0].z : v[0].w) = bad;
      const double sum = RasterBench::sum(b.draw(v)[0]);
      CHECK((sum == 28.0 || sum == 36.0));  // the sound triangle alone, half of the square
      b.definition.topology = Topology::Points;
      CHECK(RasterBench::sum(b.draw({v[0]})[0]) == 0.0);
    }
}

TEST_CASE("clipping: a vertex whose w is infinite lies at the view's centre") {
  // x / w and y / w go to 0 with growing w; llvmpipe draws it there too.
  RasterBench b = counting(8, 8);
  b.definition.topology = Topology::Points;
  RasterVertex v = b.at(1.0, 1.0);
  v.w = std::numeric_limits<float>::infinity();
  const Image image = b.draw({v})[0];
  CHECK(RasterBench::sum(image) == 1.0);
  CHECK(image.at(4, 4, 0) + image.at(3, 3, 0) == 1.0f);
}

TEST_CASE("clipping: w = 0 and negative w draw nothing") {
  RasterBench b = counting(8, 8);
  CHECK(RasterBench::sum(b.draw(square(1.0f, 0.5f, 0.0f))[0]) == 0.0);
  CHECK(RasterBench::sum(b.draw(square(1.0f, 0.5f, -1.0f))[0]) == 0.0);
}
