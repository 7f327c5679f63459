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

TEST_CASE("cost model: for an error the fastest sizes that reach it are chosen") {
  const Demand demand{.error = 0.02, .milliseconds = {}};
  const Trial chosen = choose(model(), demand);
  CHECK(meets(chosen, demand));
  for (const int grid : {64, 128, 256, 512, 1024})
    for (const int map : {64, 128, 256, 512, 1024})
      // 0.85: the room that is left for what the model gets wrong.
      CHECK((exact(grid, map).error() > 0.85 * 0.02 ||
             exact(grid, map).milliseconds >= Approx(chosen.milliseconds)));
}

TEST_CASE("cost model: for a time the most accurate sizes within it are chosen") {
  const Demand demand{.error = {}, .milliseconds = 500.0};
  const Trial chosen = choose(model(), demand);
  CHECK(chosen.milliseconds <= 450.0);
  for (const int grid : {64, 128, 256, 512, 1024})
    for (const int map : {64, 128, 256, 512, 1024})
      CHECK((exact(grid, map).milliseconds > 450.0 || exact(grid, map).error() >= Approx(chosen.error())));
}

TEST_CASE("cost model: what cannot be reached gives the closest") {
  const Trial chosen = choose(model(), {.error = 1e-4, .milliseconds = {}});
  CHECK(chosen.grid == 2048);
  CHECK(chosen.map == 2048);
  CHECK_FALSE(meets(chosen, {.error = 1e-4, .milliseconds = {}}));
  const Trial fastest = choose(model(), {.error = {}, .milliseconds = 1.0});
  CHECK(fastest.grid == 64);
  CHECK(fastest.map == 64);
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

TEST_CASE("cost model: sizes that would take too long are not tried at once") {
  const Demand demand{.error = 0.003, .milliseconds = {}};
  CHECK(choose(model(), demand).milliseconds > 200.0);
  const Trial chosen = choose(model(), demand, 200.0);
  CHECK(chosen.milliseconds <= 200.0);
  for (const int grid : {64, 128, 256, 512})
    for (const int map : {64, 128, 256, 512})
      CHECK((exact(grid, map).milliseconds > 200.0 || exact(grid, map).error() >= Approx(chosen.error())));
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
