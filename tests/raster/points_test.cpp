// Points (OpenGL 4.5, 14.4): squares of their size around their centre.
#include "tests/raster/raster_bench.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

RasterBench points(int width, int height) {
  RasterBench b = counting(width, height);
  b.definition.topology = Topology::Points;
  return b;
}

RasterVertex point(const RasterBench& b, double x, double y, float size) {
  RasterVertex v = b.at(x, y);
  v.size = size;
  return v;
}

}  // namespace

TEST_CASE("points: a point of size 1 covers the pixel that holds its centre") {
  RasterBench b = points(8, 8);
  for (const double x : {2.01, 2.5, 2.99}) {
    const Image image = b.draw({point(b, x, 5.3, 1.0f)})[0];
    CHECK(image.at(2, 5, 0) == 1.0f);
    CHECK(RasterBench::sum(image) == 1.0);
  }
}

TEST_CASE("points: odd sizes at a pixel's centre cover as many pixels a side") {
  for (const int size : {1, 3, 5, 7}) {
    RasterBench b = points(16, 16);
    const Image image = b.draw({point(b, 8.5, 8.5, static_cast<float>(size))})[0];
    CHECK(RasterBench::sum(image) == size * size);
    CHECK(image.at(8 - size / 2, 8 + size / 2, 0) == 1.0f);
    CHECK(image.at(8 + size / 2, 8 - size / 2, 0) == 1.0f);
  }
  RasterBench large = points(256, 256);
  CHECK(RasterBench::sum(large.draw({point(large, 128.5, 128.5, 201.0f)})[0]) == 201 * 201);
}

TEST_CASE(
    "points: the square takes in its lower and left border's centres and leaves out the upper and right") {
  // Size 2 at a pixel's centre reaches from one neighbour's centre to the other's: [7.5, 9.5).
  RasterBench b = points(16, 16);
  const Image image = b.draw({point(b, 8.5, 8.5, 2.0f)})[0];
  CHECK(RasterBench::sum(image) == 4.0);
  CHECK(image.at(7, 7, 0) == 1.0f);
  CHECK(image.at(8, 8, 0) == 1.0f);
}

TEST_CASE("points: sizes below 1 are drawn as 1") {
  RasterBench b = points(8, 8);
  for (const float size : {0.5f, 0.0f, -3.0f})
    CHECK(RasterBench::sum(b.draw({point(b, 3.5, 3.5, size)})[0]) == 1.0);
}

TEST_CASE(
    "points: a point at the border is cut, not dropped, and one whose centre lies outside is dropped whole") {
  RasterBench b = points(8, 8);
  CHECK(RasterBench::sum(b.draw({point(b, 0.5, 0.5, 5.0f)})[0]) == 9.0);
  CHECK(RasterBench::sum(b.draw({point(b, 7.5, 4.5, 5.0f)})[0]) == 15.0);
  CHECK(RasterBench::sum(b.draw({point(b, -0.1, 4.5, 5.0f)})[0]) == 0.0);
  CHECK(RasterBench::sum(b.draw({point(b, 8.1, 4.5, 5.0f)})[0]) == 0.0);
}

TEST_CASE("points: one on a tile's corner covers every pixel once") {
  RasterBench b = points(96, 96);
  const Image image = b.draw({point(b, 32.0, 64.0, 8.0f)})[0];
  CHECK(RasterBench::sum(image) == 64.0);
  for (int y = 60; y < 68; ++y)
    for (int x = 28; x < 36; ++x) CHECK(image.at(x, y, 0) == 1.0f);
}

TEST_CASE("points: they face the viewer, and their varyings are constant") {
  RasterBench b = points(4, 4);
  b.definition.shader = &raster_two_targets_shader;
  b.definition.writes = {{.name = "a", .meaning = "m"}, {.name = "b", .meaning = "m"}};
  RasterVertex v = point(b, 2.0, 2.0, 2.0f);
  v.red = 0.1f;
  const std::vector<Image> images = b.draw({v});
  for (int y = 1; y < 3; ++y)
    for (int x = 1; x < 3; ++x) {
      CHECK(images[0].at(x, y, 0) == 0.1f);
      CHECK(images[1].at(x, y, 2) == 1.0f);
      CHECK(images[1].at(x, y, 3) == static_cast<float>(x) + 0.5f);
    }
}
