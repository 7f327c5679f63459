#include "passes/caustic_footprints/caustic_footprints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/measure/ledger.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Landings of a grid's vertices, in a map of 8 x 8 m with 8 texels a side: a texel is 1 m, and (x, z) lies at
// texel (x + 4, 4 - z). Steps are in parts of the map: 1/8 is a texel.
struct Bench {
  int grid = 1;
  glm::vec2 place{3.5f, 2.5f};  // texels, of all landings
  glm::vec4 steps{0.0f};        // along the grid's rows, and its columns, texels
  float status = STATUS_LANDED;
  float taken = 0.0f;  // 1: by all cells
  float largest = 32.0f;
  float enlarged = 1.0f;  // of the map's middle, as a cascade's map shows it
  bool is_part = false;

  Image map() const {
    const glm::vec4 landing(place.x - 4.0f, 0.0f, 4.0f - place.y, status);
    std140::CausticFootprints u{};
    u.map = shader_view(down(4.0, 10.0, 20.0));
    u.scale = glm::vec2(8.0f * enlarged);
    u.offset = glm::vec2(4.0f - 4.0f * enlarged);
    u.largest = largest;
    u.grid_side = grid;
    u.map_side = 8;
    u.is_part = is_part ? 1 : 0;
    return run_pass(
        definition_with(caustic_footprints_pass(), &Effects::coloured_caustics),
        {.width = 8,
         .height = 8,
         .uniforms = uniform_bytes(u),
         .textures = {filled(grid, grid, landing), filled(grid, grid, {1.0f, 2.0f, 4.0f, 0.0f}),
                      filled(grid, grid, steps * 0.125f), filled(grid, grid, {0.0f, 0.0f, 0.0f, taken})},
         .vertex_count = grid * grid})["caustic_map"];
  }
};

// From 0 to 1, the same everywhere.
class Sequence {
 public:
  float operator()() {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<float>(state_ >> 8) / 16777216.0f;
  }

 private:
  std::uint32_t state_ = 1;
};

Image map_of(glm::vec2 place, glm::vec4 steps) {
  Bench bench;
  bench.place = place;
  bench.steps = steps;
  return bench.map();
}

// How far a map's flux is off the landing's.
double lost_of(glm::vec2 place, glm::vec4 steps) { return std::fabs(sum(map_of(place, steps)) - 1.0); }

}  // namespace

TEST_CASE("caustic_footprints: a footprint that is a texel gives it all") {
  const Image map = map_of({3.5f, 2.5f}, {1.0f, 0.0f, 0.0f, 1.0f});
  CHECK(texel(map, 3, 2) == glm::vec4(1.0f, 2.0f, 4.0f, 1.0f));
  CHECK(sum(map) == 1.0);
}

TEST_CASE("caustic_footprints: a footprint without width is a square of half a texel") {
  // From (3.45, 1.95) to (3.95, 2.45): a tenth of it is in row 1.
  const Image point = map_of({3.7f, 2.2f}, glm::vec4(0.0f));
  CHECK(point.at(3, 2, 0) == Approx(0.9).epsilon(1e-5));
  CHECK(point.at(3, 1, 0) == Approx(0.1).epsilon(1e-4));
  CHECK(sum(point, 3) == Approx(1.0));
}

TEST_CASE(
    "caustic_footprints: a thin footprint is half a texel wide, whichever of its steps is the long one") {
  // 4 texels long, from x = 2 to 6, and from y = 2.25 to 2.75 instead of a tenth of a texel, slanted or not.
  for (const glm::vec4 steps : {glm::vec4(4.0f, 0.0f, 0.0f, 0.1f), glm::vec4(0.0f, 0.1f, 4.0f, 0.0f),
                                glm::vec4(-4.0f, 0.0f, 0.0f, 0.0f)}) {
    const Image map = map_of({4.0f, 2.5f}, steps);
    for (int x = 2; x < 6; ++x) CHECK(map.at(x, 2, 0) == Approx(0.25).epsilon(1e-5));
    CHECK(sum(map) == Approx(1.0));
  }
}

TEST_CASE("caustic_footprints: texels get a rectangle's light by area") {
  // 2 x 1 texels around (3.5, 3.75): columns 2, 3, 4 hold 1/4, 1/2, 1/4 of the width, rows 3 and 4 hold 3/4
  // and 1/4. Whichever way the steps go.
  for (const glm::vec4 steps : {glm::vec4(2.0f, 0.0f, 0.0f, 1.0f), glm::vec4(-2.0f, 0.0f, 0.0f, 1.0f),
                                glm::vec4(0.0f, 1.0f, 2.0f, 0.0f), glm::vec4(0.0f, -1.0f, -2.0f, 0.0f)}) {
    const Image map = map_of({3.5f, 3.75f}, steps);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) {
        const double wide = x == 3 ? 0.5 : x == 2 || x == 4 ? 0.25 : 0.0;
        const double high = y == 3 ? 0.75 : y == 4 ? 0.25 : 0.0;
        CHECK(map.at(x, y, 1) == Approx(2.0 * wide * high).margin(1e-7));
      }
  }
}

TEST_CASE("caustic_footprints: a slanted footprint is a parallelogram") {
  // From (2, 2) by (2, 0) and (1, 1): of its area of 2 the texels of row 2 have 1/2, 1 and 1/2.
  const Image map = map_of({3.5f, 2.5f}, {2.0f, 0.0f, 1.0f, 1.0f});
  CHECK(map.at(2, 2, 0) == Approx(0.25));
  CHECK(map.at(3, 2, 0) == Approx(0.5));
  CHECK(map.at(4, 2, 0) == Approx(0.25));
  CHECK(sum(map) == Approx(1.0));
}

TEST_CASE("caustic_footprints: all flux is in the map whatever the footprint") {
  // A fixed sequence of parallelograms with sides of 1 to 2 texels at 45 to 135 degrees, in the map's middle:
  // rounding only.
  Sequence next;
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    const float turn = 6.2831853f * next(), between = 0.7853982f + 1.5707963f * next();
    const float along = 1.0f + next(), across = 1.0f + next();
    const glm::vec4 steps(along * std::cos(turn), along * std::sin(turn), across * std::cos(turn + between),
                          across * std::sin(turn + between));
    worst = std::max(worst, lost_of({3.5f + next(), 3.5f + next()}, steps));
  }
  CHECK(worst < 1e-6);
}

TEST_CASE("caustic_footprints: nor do slivers, specks, and what is larger than the map lose any") {
  Sequence next;
  double worst = 0.0;
  for (int i = 0; i < 300; ++i) {
    const float size = 32.0f * std::pow(0.5f, static_cast<float>(i % 16));
    const float thin = i % 3 == 0 ? 1e-3f : 1.0f;
    const glm::vec4 steps(next() - 0.5f, next() - 0.5f, thin * (next() - 0.5f), thin * (next() - 0.5f));
    worst = std::max(worst, lost_of({8.0f * next(), 8.0f * next()}, steps * size));
  }
  CHECK(worst < 1e-6);
}

TEST_CASE("caustic_footprints: at the map's border a footprint shrinks, and keeps its shape and its light") {
  // 4 x 2 texels around (1, 4): 1 texel is left to the side, of which 3/4 is used, so it is 1.5 x 0.75 there.
  const Image map = map_of({1.0f, 4.0f}, {4.0f, 0.0f, 0.0f, 2.0f});
  for (int x = 0; x < 2; ++x)
    for (int y = 3; y < 5; ++y) CHECK(map.at(x, y, 0) == Approx(0.25).epsilon(1e-5));
  CHECK(sum(map) == Approx(1.0).epsilon(1e-6));
  // Nearer than half a texel to the edge it is laid half a texel off it.
  const Image corner = map_of({7.875f, 0.125f}, {3.0f, 1.0f, -1.0f, 3.0f});
  CHECK(corner.at(7, 0, 0) == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("caustic_footprints: a footprint is as large as it may be and no larger") {
  // 4 texels instead of 6: columns 2 to 5 of row 4 get a quarter each.
  Bench bench;
  bench.place = {4.0f, 4.5f};
  bench.steps = {6.0f, 0.0f, 0.0f, 0.0f};
  bench.largest = 4.0f;
  const Image map = bench.map();
  for (int x = 2; x < 6; ++x) CHECK(map.at(x, 4, 0) == Approx(0.25).epsilon(1e-5));
  CHECK(sum(map) == Approx(1.0));
}

TEST_CASE("caustic_footprints: a footprint that is no number is laid as a point") {
  for (const float bad :
       {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 3e38f}) {
    const Image map = map_of({3.5f, 2.5f}, {bad, 0.0f, 0.0f, 1.0f});
    CHECK(map.at(3, 2, 0) == 1.0f);
    CHECK(sum(map) == 1.0);
  }
}

TEST_CASE("caustic_footprints: what cells have taken is not laid again, each has a quarter") {
  // Cells beside and below a vertex have taken: one at the grid's first corner, two along its first row and
  // column, four at its inside.
  Bench bench;
  bench.grid = 2;
  CHECK(sum(bench.map()) == Approx(4.0));
  bench.taken = 1.0f;
  CHECK(sum(bench.map()) == Approx(4.0 - 0.25 * (1 + 2 + 2 + 4)));
}

TEST_CASE("caustic_footprints: only what has landed is laid") {
  Bench bench;
  for (const LandingStatus status : {LandingStatus::Empty, LandingStatus::Missed, LandingStatus::Outside,
                                     LandingStatus::Absorbed, LandingStatus::GivenUp}) {
    bench.status = static_cast<float>(status);
    CHECK(sum(bench.map()) == 0.0);
  }
}

TEST_CASE("caustic_footprints: a finer map shows its part of the whole one larger") {
  // Twice as large around the middle: a landing at texel (3.5, 4.5) is at (3, 5), and a texel is two wide.
  Bench bench;
  bench.place = {3.5f, 4.5f};
  bench.steps = {1.0f, 0.0f, 0.0f, 1.0f};
  bench.enlarged = 2.0f;
  const Image map = bench.map();
  for (int x = 2; x < 4; ++x)
    for (int y = 4; y < 6; ++y) CHECK(map.at(x, y, 0) == Approx(0.25).epsilon(1e-5));
  // What lies beyond it is left out.
  bench.place = {0.5f, 4.5f};
  CHECK(sum(bench.map()) == 0.0);
}

TEST_CASE("caustic_footprints: a cascade shows its part of a footprint across its edge, as large as it is") {
  // 4 x 2 texels around a middle half a texel outside, and inside: columns 0 and 1 get an eighth each, and
  // half of one, in both rows.
  Bench bench;
  bench.is_part = true;
  bench.steps = {4.0f, 0.0f, 0.0f, 2.0f};
  bench.place = {-0.5f, 4.0f};
  const Image outside = bench.map();
  CHECK(outside.at(0, 3, 0) == Approx(0.125).epsilon(1e-5));
  CHECK(outside.at(1, 4, 0) == Approx(0.0625).epsilon(1e-5));
  CHECK(sum(outside) == Approx(3.0 / 8.0).epsilon(1e-5));
  bench.place = {0.5f, 4.0f};
  CHECK(sum(bench.map()) == Approx(5.0 / 8.0).epsilon(1e-5));
}
