#include "lab/study/sentence.hpp"

#include "tests/support/catch.hpp"

using namespace caustics::study;

namespace {

const Knob kGrid{"grid", {"256", "512"}, "512", true};

StudyRow row(const std::string& grid, std::optional<double> error, const Times& time) {
  StudyRow result{.point = {{grid}, "grid"}, .backend = "software", .device = "", .settings = {}};
  result.figures.relative_l1 = error;
  result.caustic = time;
  return result;
}

}  // namespace

TEST_CASE("study sentence: what a step brings and costs") {
  CHECK(step_sentence(kGrid, 0, row("256", 0.0038, {22, 21, 23}), row("512", 0.00334, {38, 37, 39})) ==
        "grid from 256 to 512: error -12 % (0.0038 to 0.00334), time +73 % (22 to 38 ms)");
}

TEST_CASE("study sentence: times whose frames overlap are said to be alike") {
  CHECK(step_sentence(kGrid, 0, row("256", 0.5, {22, 20, 30}), row("512", 0.5, {24, 21, 26})) ==
        "grid from 256 to 512: error +0 % (0.5 to 0.5), time +9 % (22 to 24 ms), within the spread of the "
        "frames");
}

TEST_CASE("study sentence: no share of nothing, and no error where there is none") {
  CHECK(step_sentence(kGrid, 0, row("256", 0.0, {10, 10, 10}), row("512", 0.25, {80, 80, 80})) ==
        "grid from 256 to 512: error (0 to 0.25), time x 8 (10 to 80 ms)");
  CHECK(step_sentence(kGrid, 0, row("256", std::nullopt, {10, 10, 10}), row("512", 0.25, {5, 5, 5})) ==
        "grid from 256 to 512: no error to compare, time -50 % (10 to 5 ms)");
}

TEST_CASE("study sentence: where the truth's noise rules, it says so") {
  StudyRow to = row("512", 0.001, {9, 9, 9});
  to.reference_limited = true;
  CHECK(step_sentence(kGrid, 0, row("256", 0.002, {5, 5, 5}), to) ==
        "grid from 256 to 512: error -50 % (0.002 to 0.001), as small as the truth's own noise can tell, "
        "time +80 % (5 "
        "to 9 ms)");
}

TEST_CASE("study sentence: a row that could not be measured is named") {
  StudyRow to = row("512", std::nullopt, {});
  to.problem = "too large";
  CHECK(step_sentence(kGrid, 0, row("256", 0.1, {5, 5, 5}), to) ==
        "grid from 256 to 512: no answer, too large");
}

TEST_CASE("study names: points are named by what differs from the base") {
  const std::vector<Knob> knobs{
      kGrid, {"splat.sigma", {"0.5"}, "0.7", true}, {"splat", {"point"}, "cell", false}};
  CHECK(point_text(knobs, {{"512", "0.7", "cell"}, ""}) == "base");
  CHECK(point_text(knobs, {{"256", "0.7", "point"}, ""}) == "grid 256, splat point");
  CHECK(point_file(knobs, {{"256", "0.5", "cell"}, ""}) == "grid256_splat.sigma0.5");
  const Knob rude{"camera", {"../a b"}, "", false};
  CHECK(point_file({rude}, {{"../a b"}, ""}) == "camera..-a-b");
}

TEST_CASE("study names: many keys still make a file's name") {
  std::vector<Knob> knobs;
  Point point;
  for (int k = 0; k < 40; ++k) {
    knobs.push_back({"medium.steps" + std::to_string(k), {}, "1", true});
    point.values.emplace_back("1024");
  }
  const std::string name = point_file(knobs, point);
  CHECK(name.size() == 120);
  point.values.back() = "1023";
  CHECK(point_file(knobs, point) != name);
}

TEST_CASE("study numbers: short, and whole from a hundred on") {
  CHECK(short_number(0.0033244) == "0.00332");
  CHECK(short_number(99.94) == "99.9");
  CHECK(short_number(99.96) == "100");
  CHECK(short_number(1840.4) == "1840");
  CHECK(change_text(1.0, 1.004) == "+0 %");
  CHECK(change_text(2.0, 1.0) == "-50 %");
  CHECK(change_text(1.0, 2.0) == "x 2");
  CHECK(change_text(0.0, 2.0).empty());
}
