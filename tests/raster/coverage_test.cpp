// Which texels triangles cover: OpenGL 4.5, 14.6.1, with left and bottom edges inclusive (y up).
#include <cmath>
#include <string>

#include "tests/raster/raster_bench.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// The texels that are covered, as rows of '#' and '.', the top row first, as a person draws them.
std::string drawing(const Image& image) {
  std::string text;
  for (int y = image.height() - 1; y >= 0; --y) {
    for (int x = 0; x < image.width(); ++x) text += image.at(x, y, 0) != 0.0f ? '#' : '.';
    text += '\n';
  }
  return text;
}

// Every texel of a region holds exactly `count`.
bool all_equal(const Image& image, int x0, int y0, int x1, int y1, float count) {
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      if (image.at(x, y, 0) != count) return false;
  return true;
}

}  // namespace

TEST_CASE("coverage: a right triangle covers the pixels whose centres lie inside") {
  RasterBench b = counting(4, 4);
  // Legs of 4 pixels from the lower left corner; the long edge passes through the centres with x + y = 3
  // (pixel numbers), which it, being a right-hand edge, leaves out.
  CHECK(drawing(b.draw({b.at(0, 0), b.at(4, 0), b.at(0, 4)})[0]) ==
        "....\n"
        "#...\n"
        "##..\n"
        "###.\n");
}

TEST_CASE(
    "coverage: left and bottom edges through pixel centres belong to the triangle, right and top do not") {
  RasterBench b = counting(4, 4);
  // The square from centre (0.5, 0.5) to centre (2.5, 2.5): pixels 0 and 1 in both directions.
  const auto image = b.draw(
      {b.at(0.5, 0.5), b.at(2.5, 0.5), b.at(2.5, 2.5), b.at(0.5, 0.5), b.at(2.5, 2.5), b.at(0.5, 2.5)})[0];
  CHECK(drawing(image) ==
        "....\n"
        "....\n"
        "##..\n"
        "##..\n");
  CHECK(all_equal(image, 0, 0, 2, 2, 1.0f));
}

TEST_CASE("coverage: a step of 1/256 of a pixel decides whether a centre is covered") {
  // A right-hand edge at x = 2.5 leaves the centre of column 2 out; 1/256 further it takes it in.
  RasterBench b = counting(4, 4);
  const auto column_2 = [&](double right) {
    return b.draw({b.at(0, 0), b.at(right, 0), b.at(right, 4), b.at(0, 0), b.at(right, 4), b.at(0, 4)})[0].at(
        2, 1, 0);
  };
  CHECK(column_2(2.5) == 0.0f);
  CHECK(column_2(2.5 + 1.0 / 256.0) == 1.0f);
  CHECK(column_2(2.5 - 1.0 / 256.0) == 0.0f);
}

TEST_CASE("coverage: window coordinates are snapped to 1/256 with ties to even") {
  // Half a step above 2.5 is a tie between 512/256 (even) and 513/256 past the centre: it goes to 2.5 and
  // the centre stays out. One and a half steps go to two.
  RasterBench b = counting(4, 4);
  const auto column_2 = [&](double right) {
    return b.draw({b.at(0, 0), b.at(right, 0), b.at(right, 4), b.at(0, 0), b.at(right, 4), b.at(0, 4)})[0].at(
        2, 1, 0);
  };
  CHECK(column_2(2.5 + 0.5 / 256.0) == 0.0f);
  CHECK(column_2(2.5 + 0.75 / 256.0) == 1.0f);
  CHECK(column_2(2.5 + 1.5 / 256.0) == 1.0f);
}

TEST_CASE("coverage: a fan around a pixel centre covers every pixel once") {
  // Twelve triangles meet in the centre of pixel (4, 4); the outer square is cut at uneven places.
  RasterBench b = counting(9, 9);
  const double ring[12][2] = {{0, 0}, {3.3, 0}, {6.1, 0}, {9, 0}, {9, 2.7}, {9, 6.6},
                              {9, 9}, {5.5, 9}, {2.2, 9}, {0, 9}, {0, 4.5}, {0, 1.1}};
  std::vector<RasterVertex> v;
  for (int i = 0; i < 12; ++i) {
    v.push_back(b.at(4.5, 4.5));
    v.push_back(b.at(ring[i][0], ring[i][1]));
    v.push_back(b.at(ring[(i + 1) % 12][0], ring[(i + 1) % 12][1]));
  }
  CHECK(all_equal(b.draw(v)[0], 0, 0, 9, 9, 1.0f));
}

TEST_CASE("coverage: a shared edge covers each texel once whatever its direction and slope") {
  // A square cut by a line through its middle, at 64 angles; the two sides drawn with opposite windings.
  for (int angle = 0; angle < 64; ++angle) {
    RasterBench b = counting(40, 40);
    const double a = 3.14159265358979 * angle / 64.0;
    const double dx = 60.0 * std::cos(a), dy = 60.0 * std::sin(a);
    const RasterVertex p = b.at(20 + dx, 20 + dy), q = b.at(20 - dx, 20 - dy);
    const RasterVertex left = b.at(20 - dy, 20 + dx), right = b.at(20 + dy, 20 - dx);
    INFO("angle " << angle);
    CHECK(all_equal(b.draw({q, p, left, q, p, right})[0], 4, 4, 36, 36, 1.0f));
  }
}

TEST_CASE("coverage: degenerate and sub-pixel triangles that miss all centres cover nothing") {
  RasterBench b = counting(4, 4);
  CHECK(RasterBench::sum(b.draw({b.at(0, 0), b.at(4, 4), b.at(2, 2)})[0]) == 0.0);
  CHECK(RasterBench::sum(b.draw({b.at(1, 1), b.at(1, 1), b.at(3, 2)})[0]) == 0.0);
  CHECK(RasterBench::sum(b.draw({b.at(1.6, 1.6), b.at(1.9, 1.6), b.at(1.6, 1.9)})[0]) == 0.0);
  CHECK(RasterBench::sum(b.draw({b.at(1.4, 1.4), b.at(1.7, 1.4), b.at(1.4, 1.7)})[0]) == 1.0);
}

TEST_CASE("coverage: counter-clockwise triangles face the viewer, and culling drops one side") {
  RasterBench b = counting(4, 4);
  const std::vector<RasterVertex> front = {b.at(0, 0), b.at(4, 0), b.at(4, 4)};
  const std::vector<RasterVertex> back = {b.at(0, 0), b.at(4, 4), b.at(4, 0)};
  b.definition.cull = Cull::Back;
  CHECK(RasterBench::sum(b.draw(front)[0]) > 0.0);
  CHECK(RasterBench::sum(b.draw(back)[0]) == 0.0);
  b.definition.cull = Cull::Front;
  CHECK(RasterBench::sum(b.draw(front)[0]) == 0.0);
  CHECK(RasterBench::sum(b.draw(back)[0]) > 0.0);
}

TEST_CASE("coverage: tiles leave no seams") {
  // 100 x 70 pixels are 4 x 3 tiles, the last ones partly; one triangle over everything, far larger.
  RasterBench b = counting(100, 70);
  const auto image = b.draw({b.at(-300, -300), b.at(500, -300), b.at(-300, 500)})[0];
  CHECK(all_equal(image, 0, 0, 100, 70, 1.0f));
  CHECK(b.result.fragments == 7000);
}
