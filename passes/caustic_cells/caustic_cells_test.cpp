#include "passes/caustic_cells/caustic_cells.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// One cell with flux (1, 2, 4) in a map of 8 x 8, or a cascade.
struct Cell {
  glm::vec2 a, b, c, d;  // texels
  glm::vec2 scale{1.0f}, offset{0.0f};

  Image laid(bool leaves_out = true) const {
    PassDefinition definition = definition_with(caustic_cells_pass(), &Effects::coloured_caustics);
    if (!leaves_out) definition.zero_outside_quad.reset();
    return run_pass(definition, {.width = 8,
                                 .height = 8,
                                 .uniforms = uniform_bytes(std140::CausticCells{
                                     .scale = scale, .offset = offset, .cells_a_side = 1, .map_side = 8}),
                                 .textures = {filled(1, 1, {a, b}), filled(1, 1, {c, d}),
                                              filled(1, 1, {1.0f, 2.0f, 4.0f, 1.0f})},
                                 .vertex_count = 1})["caustic_map"];
  }
};

Image lay(glm::vec2 a, glm::vec2 b, glm::vec2 c, glm::vec2 d) { return Cell{a, b, c, d}.laid(); }

// The cascade shows the caustic map's texels 2 to 6: one texel there is two by two here.
Image lay_in_cascade(glm::vec2 a, glm::vec2 b, glm::vec2 c, glm::vec2 d) {
  return Cell{a, b, c, d, glm::vec2(2.0f), glm::vec2(-4.0f)}.laid();
}

}  // namespace

TEST_CASE("caustic_cells: a cell that is a texel gives it all") {
  const Image map = lay({3, 2}, {4, 2}, {3, 3}, {4, 3});
  CHECK(texel(map, 3, 2) == glm::vec4(1.0f, 2.0f, 4.0f, 1.0f));
  CHECK(sum(map) == 1.0);
}

TEST_CASE("caustic_cells: texels get a rectangle's light by area") {
  // 2 x 1 texels from (2.5, 3.25): columns 2, 3, 4 hold 1/4, 1/2, 1/4 of the width, rows 3 and 4 hold 3/4 and
  // 1/4.
  const Image map = lay({2.5f, 3.25f}, {4.5f, 3.25f}, {2.5f, 4.25f}, {4.5f, 4.25f});
  CHECK(map.at(2, 3, 0) == Approx(0.25 * 0.75));
  CHECK(map.at(3, 3, 0) == Approx(0.5 * 0.75));
  CHECK(map.at(4, 4, 1) == Approx(2.0 * 0.25 * 0.25));
  CHECK(sum(map, 2) == Approx(4.0));
}

TEST_CASE("caustic_cells: a slanted edge cuts texels by area") {
  // Triangle (2, 2), (4, 2), (2, 4) and its mirror image (4, 4): a square of 2 x 2, half of it each. With d
  // at b the second triangle has no height and is the line from b to c.
  const Image square = lay({2, 2}, {4, 2}, {2, 4}, {4, 4});
  for (int y = 2; y < 4; ++y)
    for (int x = 2; x < 4; ++x) CHECK(square.at(x, y, 0) == Approx(0.25));
  // The triangle has area 2: texel (2, 2) is a half of it, (3, 2) and (2, 3) a quarter each.
  const Image half = lay({2, 2}, {4, 2}, {2, 4}, {4, 2});
  CHECK(half.at(2, 2, 0) == Approx(0.5 * 0.5));
  // The line's light grows from nothing at c evenly towards b, where its third corner is: 1/4 and 3/4.
  CHECK(half.at(3, 2, 0) == Approx(0.5 * 0.25 + 0.5 * 0.75));
  CHECK(half.at(2, 3, 0) == Approx(0.5 * 0.25 + 0.5 * 0.25));
  CHECK(sum(half) == Approx(1.0));
}

TEST_CASE("caustic_cells: a cell may be turned over, folded or crossed") {
  // The same square, its corners taken the other way round.
  const Image turned = lay({4, 2}, {2, 2}, {4, 4}, {2, 4});
  CHECK(turned.at(2, 2, 0) == Approx(0.25));
  CHECK(sum(turned) == Approx(1.0));
  // d folded back onto a: both triangles are the same half.
  const Image folded = lay({2, 2}, {4, 2}, {2, 4}, {2, 2});
  CHECK(folded.at(2, 2, 0) == Approx(0.5));
  CHECK(folded.at(3, 3, 0) == Approx(0.0).margin(1e-7));
  CHECK(sum(folded) == Approx(1.0));
}

TEST_CASE("caustic_cells: a cell without height is a line, one without extent a point") {
  // From (1.5, 3.5) to (5.5, 3.5), b and c between at its quarter points: tents with peaks at 1/4 + ...
  const Image line = lay({1.5f, 3.5f}, {2.5f, 3.5f}, {4.5f, 3.5f}, {5.5f, 3.5f});
  CHECK(sum(line) == Approx(1.0));
  for (int x = 0; x < 8; ++x) CHECK(line.at(x, 2, 0) == 0.0f);
  // Triangle a, b, c spans 1.5 to 4.5 with its third corner at 1/3: up to x = 2 (t = 1/6) lies t^2 / s =
  // 1/12.
  CHECK(line.at(1, 3, 0) == Approx(0.5 / 12.0));
  const Image point = lay({3.7f, 2.2f}, {3.7f, 2.2f}, {3.7f, 2.2f}, {3.7f, 2.2f});
  CHECK(point.at(3, 2, 0) == 1.0f);
  CHECK(sum(point) == 1.0);
}

TEST_CASE("caustic_cells: flux is kept whatever the shape") {
  // A fixed sequence of quadrilaterals from round and large to needles: rounding only.
  std::uint32_t state = 1;
  const auto next = [&] {
    state = state * 1664525u + 1013904223u;
    return static_cast<float>(state >> 8) / 16777216.0f;
  };
  double worst = 0.0;
  for (int i = 0; i < 300; ++i) {
    const float size = std::pow(0.5f, static_cast<float>(i % 16));
    const glm::vec2 centre{1.0f + 6.0f * next(), 1.0f + 6.0f * next()};
    glm::vec2 corner[4];
    for (glm::vec2& c : corner)
      c = centre + glm::vec2(next() - 0.5f, (i % 3 == 0 ? 1e-3f : 1.0f) * (next() - 0.5f)) * size;
    worst = std::max(worst, std::fabs(sum(lay(corner[0], corner[1], corner[2], corner[3])) - 1.0));
  }
  // A triangle 1/256 texel high and one long loses at most 2^-24 * 4 texels squared of 1/512.
  CHECK(worst < 1.3e-4);
}

TEST_CASE("caustic_cells: at the map's edge nothing is lost") {
  const Image corner = lay({7.0f, 7.5f}, {7.99f, 7.5f}, {7.0f, 7.99f}, {7.99f, 7.99f});
  CHECK(corner.at(7, 7, 0) == Approx(1.0));
  const Image wide = lay({0.0f, 7.0f}, {7.99f, 7.0f}, {0.0f, 7.99f}, {7.99f, 7.99f});
  CHECK(sum(wide) == Approx(1.0));
}

TEST_CASE("caustic_cells: texels beside a cell get nothing, so that they may be left out") {
  // Long, aslant and thin, with corners that need all of their digits, in the first column too.
  for (const float x : {0.0f, 0.1234567f, 3.0f}) {
    const Cell cell{{x + 0.1f, 0.37f}, {x + 0.3f, 0.31f}, {x + 4.1f, 7.77f}, {x + 4.3f, 7.71f}};
    const Image map = cell.laid(false);
    CHECK(sum(map) == Approx(1.0));
    for (int row = 3; row < 8; ++row) CHECK(map.at(static_cast<int>(x), row, 0) == 0.0f);
    for (int row = 0; row < 5; ++row) CHECK(map.at(static_cast<int>(x) + 4, row, 0) == 0.0f);
    CHECK(cell.laid().values == map.values);
  }
  // Any four corners, at any place: crossed, folded, without height, in the first column.
  std::uint32_t state = 1;
  const auto next = [&] {
    state = state * 1664525u + 1013904223u;
    return static_cast<float>(state >> 8) / 16777216.0f;
  };
  int others = 0;
  for (int i = 0; i < 500; ++i) {
    const float thin = i % 2 == 0 ? 1.0f : 1e-3f, middle = 8.0f * next();
    // Many lie near 0, where numbers have more digits behind the point.
    const auto corner = [&] {
      const float x = 8.0f * next() * next() * next() * next();
      return glm::vec2(x, middle + thin * (8.0f * next() - 4.0f));
    };
    const Cell cell{corner(), corner(), corner(), corner()};
    others += cell.laid().values != cell.laid(false).values;
  }
  CHECK(others == 0);
}

TEST_CASE("caustic_cells: a texel of the caustic map is shared by those of the cascade inside it") {
  const Image map = lay_in_cascade({3, 4}, {4, 4}, {3, 5}, {4, 5});
  for (const int y : {4, 5})
    for (const int x : {2, 3}) CHECK(texel(map, x, y) == glm::vec4(0.25f, 0.5f, 1.0f, 0.25f));
  CHECK(sum(map) == 1.0);
}

TEST_CASE("caustic_cells: a cell is cut at the cascade's edge") {
  // From 1 to 4 in x and 2 to 3 in y, of which 2 to 4 are shown: two thirds of the light, even over 4 x 2
  // texels.
  const Image map = lay_in_cascade({1, 2}, {4, 2}, {1, 3}, {4, 3});
  for (int x = 0; x < 4; ++x) CHECK(map.at(x, 1, 0) == Approx(1.0 / 12.0));
  CHECK(map.at(4, 0, 0) == 0.0f);
  CHECK(sum(map) == Approx(2.0 / 3.0));
}

TEST_CASE("caustic_cells: a cell larger than the cascade fills it evenly") {
  // 1000 x 1000 texels of the caustic map, of which 4 x 4 are shown.
  const Image map = lay_in_cascade({-500, -500}, {500, -500}, {-500, 500}, {500, 500});
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) CHECK(map.at(x, y, 0) == Approx(1.6e-5 / 64.0).epsilon(0.05));
}

TEST_CASE("caustic_cells: a cell beside the cascade leaves it empty") {
  CHECK(sum(lay_in_cascade({0, 0}, {1, 0}, {0, 1}, {1, 1})) == 0.0);
  CHECK(sum(lay_in_cascade({6.5f, 3}, {7, 3}, {6.5f, 4}, {7, 4})) == 0.0);
}
