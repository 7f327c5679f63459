#include "lab/study/sweep.hpp"

#include "tests/support/catch.hpp"

using namespace caustics::study;

namespace {

const Knob kGrid{"grid", {"64", "128"}, "512", true};
const Knob kMap{"map", {"128", "512"}, "512", true};
const Knob kSplat{"splat", {"point", "cell"}, "cell", false};

std::vector<std::vector<std::string>> values_of(const std::vector<Point>& points) {
  std::vector<std::vector<std::string>> values;
  values.reserve(points.size());
  for (const Point& point : points) values.push_back(point.values);
  return values;
}

}  // namespace

TEST_CASE("study sweep: one key at a time around the base, nothing twice") {
  const std::vector<Point> points = expand({kGrid, kSplat}, false);
  CHECK(points == std::vector<Point>{{{"512", "cell"}, "base"},
                                     {{"64", "cell"}, "grid"},
                                     {{"128", "cell"}, "grid"},
                                     {{"512", "point"}, "splat"}});
}

TEST_CASE("study sweep: grid and map make a product beside the single keys") {
  const std::vector<Point> points = expand({kMap, kSplat, kGrid}, false);
  CHECK(points == std::vector<Point>{{{"512", "cell", "512"}, "base"},
                                     {{"128", "cell", "512"}, "map"},
                                     {{"512", "point", "512"}, "splat"},
                                     {{"512", "cell", "64"}, "grid"},
                                     {{"512", "cell", "128"}, "grid"},
                                     {{"128", "cell", "64"}, "grid, map"},
                                     {{"128", "cell", "128"}, "grid, map"}});
}

TEST_CASE("study sweep: a product has every value beside every other") {
  CHECK(values_of(expand({kGrid, kSplat}, true)) ==
        std::vector<std::vector<std::string>>{
            {"64", "point"}, {"64", "cell"}, {"128", "point"}, {"128", "cell"}});
}

TEST_CASE("study sweep: the count never wraps round") {
  CHECK(count_points({kGrid, kMap, kSplat}, true, 1000) == 8);
  // The base, six values, and four of the product of grid and map.
  CHECK(count_points({kGrid, kMap, kSplat}, false, 1000) == 11);
  const Knob hundred{"k", std::vector<std::string>(100, "v"), "b", false};
  CHECK(count_points(std::vector<Knob>(40, hundred), true, 1000) == 1001);
}

TEST_CASE("study sweep: numbers are told about from each to the next, names from the base") {
  const Knob estimator{"estimator", {"paper", "secant", "newton"}, "secant", false};
  const Knob grid{"grid", {"128", "64", "1024"}, "512", true};
  const std::vector<Knob> knobs{grid, estimator};
  const std::vector<Point> points = expand(knobs, false);
  // 0 base, 1 grid 128, 2 grid 64, 3 grid 1024, 4 paper, 5 newton.
  CHECK(steps(knobs, points) == std::vector<Step>{{0, 2, 1}, {0, 1, 0}, {0, 0, 3}, {1, 0, 4}, {1, 0, 5}});
}

TEST_CASE("study sweep: in a product without the base the others stand at their last value") {
  const Knob grid{"grid", {"64", "128"}, "512", true}, map{"map", {"16", "32"}, "512", true};
  // 0: 64 16, 1: 64 32, 2: 128 16, 3: 128 32.
  CHECK(steps({grid, map}, expand({grid, map}, true)) == std::vector<Step>{{0, 1, 3}, {1, 2, 3}});
}

TEST_CASE(
    "study sweep: in a product each knob stands at its base where that ran, whatever the others' base") {
  const Knob grid{"grid", {"512", "64"}, "512", true}, map{"map", {"16", "32"}, "1024", true};
  // 0: 512 16, 1: 512 32, 2: 64 16, 3: 64 32.
  CHECK(steps({grid, map}, expand({grid, map}, true)) == std::vector<Step>{{0, 3, 1}, {1, 0, 1}});
}

TEST_CASE("study sweep: rows that are not there are not told about") {
  std::vector<Point> points = expand({kGrid}, false);
  points.erase(points.begin() + 2);  // grid 128
  CHECK(steps({kGrid}, points) == std::vector<Step>{{0, 1, 0}});
}
