#include "pipeline/measure/size_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

using Frame = std::function<Trial(int, int)>;

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

struct Found {
  Trial chosen;
  int trials = 0;
  bool only_model = false;
};

Found search(const Frame& frame, const Demand& demand) {
  SizeSearch search(CostModel(frame(128, 128), frame(256, 128), frame(128, 256)), demand);
  Found found;
  while (const std::optional<Trial> next = search.next()) {
    search.learn(frame(next->grid, next->map));
    ++found.trials;
  }
  found.chosen = search.chosen().value();
  found.only_model = search.only_model();
  return found;
}

constexpr int kSides[] = {64, 96, 128, 192, 256, 384, 512, 768, 1024, 1536, 2048};

// By force.
double fastest(const Frame& frame, double error) {
  double least = 1e30;
  for (const int grid : kSides)
    for (const int map : kSides)
      if (frame(grid, map).error() <= error) least = std::min(least, frame(grid, map).milliseconds);
  return least;
}

}  // namespace

TEST_CASE("size search: finds the fastest sizes that meet an error") {
  for (const double error : {0.1, 0.05, 0.02, 0.01, 0.005}) {
    const Found found = search(exact, {.error = error, .milliseconds = {}});
    CHECK(found.chosen.error() <= error);
    CHECK(found.chosen.milliseconds <= 1.12 * fastest(exact, error));
    CHECK(found.trials <= 4);
  }
}

TEST_CASE("size search: steps down again where the first sizes more than meet the error") {
  // What pilots at 128 see of the grid's error and of what is missing falls much faster than they tell.
  const Frame falls = [](int grid, int map) {
    Trial trial = exact(grid, map);
    if (grid > 256) trial.grid_error *= 0.05;
    trial.missing = grid >= 256 ? 0.0001 : 0.004;
    return trial;
  };
  const Found found = search(falls, {.error = 0.006, .milliseconds = {}});
  CHECK(found.chosen.error() <= 0.006);
  // What is expected to save less than a tenth is not tried, here twice.
  CHECK(found.chosen.milliseconds <= 1.21 * fastest(falls, 0.006));
}

TEST_CASE("size search: goes on where the first sizes do not meet the error") {
  const Frame stays = [](int grid, int map) {
    Trial trial = exact(grid, map);
    if (grid > 256) trial.grid_error = 0.02 * std::sqrt(256.0 / grid);
    return trial;
  };
  const Found found = search(stays, {.error = 0.012, .milliseconds = {}});
  CHECK(found.chosen.error() <= 0.012);
  CHECK(found.trials <= 8);
}

TEST_CASE("size search: for a time the most accurate sizes within it") {
  const Found found = search(exact, {.error = {}, .milliseconds = 500.0});
  CHECK(found.chosen.milliseconds <= 500.0);
  for (const int grid : kSides)
    for (const int map : kSides)
      CHECK(
          (exact(grid, map).milliseconds > 500.0 || exact(grid, map).error() >= 0.88 * found.chosen.error()));
}

TEST_CASE("size search: noise that hides what a side costs is found out") {
  // The pilots' maps cost nothing; the frames' do.
  int frames = 0;
  const Frame noisy = [&frames](int grid, int map) {
    Trial trial = exact(grid, map);
    if (++frames <= 3) trial.milliseconds = 10.0 + 1e-3 * grid * grid;
    return trial;
  };
  const Found found = search(noisy, {.error = {}, .milliseconds = 300.0});
  CHECK(found.chosen.milliseconds <= 300.0);
  CHECK(found.chosen.error() < 0.05);  // the best within 300 ms errs by 3 %
}

TEST_CASE("size search: where the model alone errs more, nothing is spent on what sizes cannot mend") {
  const Frame modelled = [](int grid, int map) {
    Trial trial = exact(grid, map);
    trial.model = 0.35;
    return trial;
  };
  const Found found = search(modelled, {.error = 0.001, .milliseconds = {}});
  CHECK(found.only_model);
  // A quarter of 0.35 for the sizes.
  CHECK(found.chosen.of_sizes() <= 0.0875);
  CHECK(found.chosen.milliseconds <= 1.12 * fastest(exact, 0.0875));
}

TEST_CASE("size search: what sizes have to meet is what the model leaves of the demand") {
  const Frame modelled = [](int grid, int map) {
    Trial trial = exact(grid, map);
    trial.model = 0.01;
    return trial;
  };
  const Found found = search(modelled, {.error = 0.02, .milliseconds = {}});
  CHECK_FALSE(found.only_model);
  CHECK(found.chosen.error() <= 0.02);
}

TEST_CASE("size search: a model's error that few rays show too large is not taken for what no size mends") {
  // As a drinking glass states it: 46 % with grids to 128, 34 % with finer ones.
  const Frame few_rays = [](int grid, int map) {
    Trial trial = exact(grid, map);
    trial.map_error *= 0.1;
    trial.grid_error *= 0.1;
    trial.model = grid < 192 ? 0.46 : 0.34;
    return trial;
  };
  const Found found = search(few_rays, {.error = 0.36, .milliseconds = {}});
  CHECK(found.chosen.error() <= 0.36);
  CHECK(found.chosen.milliseconds <= 1.12 * fastest(few_rays, 0.36));
  CHECK(!found.only_model);
}

TEST_CASE("size search: what cannot be reached gives what comes close, not the most expensive") {
  // Beyond 512 nothing helps.
  const Frame floored = [](int grid, int map) {
    Trial trial = exact(std::min(grid, 512), std::min(map, 512));
    trial.grid = grid;
    trial.map = map;
    trial.milliseconds = exact(grid, map).milliseconds;
    return trial;
  };
  const Found found = search(floored, {.error = 1e-4, .milliseconds = {}});
  CHECK(found.chosen.error() <= 1.1 * floored(2048, 2048).error());
  const Found fast = search(exact, {.error = {}, .milliseconds = 1.0});
  CHECK(fast.chosen.grid == 64);
  CHECK(fast.chosen.map == 64);
}

TEST_CASE("size search: what hardly lowers an error that cannot be reached is not tried") {
  // A tenth of the light is missing whatever the sizes: the first ones come so close to that error that no
  // finer ones take a tenth off what they leave.
  const Frame missing = [](int grid, int map) {
    Trial trial = exact(grid, map);
    trial.missing = 0.1;
    return trial;
  };
  CHECK(search(missing, {.error = 0.05, .milliseconds = {}}).trials == 1);
}

TEST_CASE("size search: of all sizes that would be better the best is tried, not the first or the last") {
  // An error of 0.42 is met by every size from 64 on: of them 64 x 64 is the quickest.
  SizeSearch quick(CostModel(exact(128, 128), exact(256, 128), exact(128, 256)),
                   {.error = 0.42, .milliseconds = {}});
  quick.learn(exact(512, 512));
  REQUIRE(quick.next());
  CHECK((quick.next()->grid == 64 && quick.next()->map == 64));
  // Within 100 ms small sizes fit too, but err more than the best of those that fit.
  SizeSearch accurate(CostModel(exact(128, 128), exact(256, 128), exact(128, 256)),
                      {.error = {}, .milliseconds = 100.0});
  accurate.learn(exact(64, 64));
  REQUIRE(accurate.next());
  const Trial next = *accurate.next();
  for (const int grid : kSides)
    for (const int map : kSides)
      if (exact(grid, map).milliseconds <= 100.0) CHECK(next.error() <= exact(grid, map).error() * 1.001);
}
