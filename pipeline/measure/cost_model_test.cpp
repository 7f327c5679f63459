#include "pipeline/measure/cost_model.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

// Errors fall with the square of the map's side and with the grid's; time is 10 ms, a microsecond a vertex
// and two a texel.
Trial exact(int grid, int map) {
  return {.grid = grid,
          .map = map,
          .map_error = 0.08 * (128.0 / map) * (128.0 / map),
          .grid_error = 0.04 * 128.0 / grid,
          .missing = 0.001,
          .milliseconds = 10.0 + 1e-3 * grid * grid + 2e-3 * map * map};
}

CostModel model() { return {exact(128, 128), exact(256, 128), exact(128, 256)}; }

}  // namespace

TEST_CASE("cost model: orders of error and costs follow from three trials") {
  const Trial expected = model().expect(512, 1024);
  CHECK(expected.map_error == Approx(exact(512, 1024).map_error));
  CHECK(expected.grid_error == Approx(exact(512, 1024).grid_error));
  CHECK(expected.milliseconds == Approx(exact(512, 1024).milliseconds));
}

TEST_CASE("cost model: a trial corrects it") {
  CostModel corrected = model();
  Trial slow = exact(512, 512);
  slow.milliseconds *= 3.0;
  slow.grid_error *= 2.0;
  corrected.learn(slow);
  CHECK(corrected.expect(512, 512).milliseconds == Approx(slow.milliseconds));
  // From 0.04 at 128 to 0.02 at 512: by the square root.
  CHECK(corrected.expect(2048, 512).grid_error == Approx(0.01));
}

TEST_CASE("cost model: maps that seemed to cost nothing cost what a larger one shows") {
  // Noise has hidden the map's 98 ms: 59 ms for the base too.
  Trial base = exact(128, 128), finer_map = exact(128, 256);
  finer_map.milliseconds = base.milliseconds;
  CostModel corrected(base, exact(256, 128), finer_map);
  CHECK(corrected.expect(128, 1024).milliseconds < 80.0);
  corrected.learn(exact(128, 1024));
  CHECK(corrected.expect(128, 1024).milliseconds == Approx(exact(128, 1024).milliseconds));
  CHECK(corrected.expect(128, 512).milliseconds == Approx(exact(128, 512).milliseconds).epsilon(0.1));
  CHECK(corrected.expect(128, 64).milliseconds < 1.3 * base.milliseconds);  // not 30 times, all costs alike
}

TEST_CASE("cost model: errors that do not fall, and times that do not rise, are survived") {
  const Trial same{
      .grid = 128, .map = 128, .map_error = 0.0, .grid_error = 0.1, .missing = 0.0, .milliseconds = 5.0};
  Trial finer_grid = same, finer_map = same;
  finer_grid.grid = finer_map.map = 256;
  finer_grid.grid_error = 0.2;
  const CostModel flat(same, finer_grid, finer_map);
  CHECK(flat.expect(2048, 2048).milliseconds == Approx(5.0));
  CHECK(flat.expect(2048, 2048).grid_error < 0.1);
}

TEST_CASE(
    "cost model: what a coarser grid states of its model's error replaces nothing that a finer one stated") {
  CostModel learned = model();
  Trial fine = exact(512, 512), coarse = exact(256, 512);
  fine.model = 0.03;
  coarse.model = 0.09;
  learned.learn(fine);
  learned.learn(coarse);
  CHECK(learned.expect(256, 512).model == 0.03);
  Trial finer = exact(1024, 512);
  finer.model = 0.02;
  learned.learn(finer);
  CHECK(learned.expect(256, 512).model == 0.02);
}
