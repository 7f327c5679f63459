// What a study writes of itself, and reads back.
#include "lab/study/report_page.hpp"
#include "lab/study/study.hpp"
#include "tests/support/catch.hpp"

using namespace caustics::study;

namespace {

StudyRow row_with(const std::string& grid, double error) {
  StudyRow row{.point = {{grid}, "grid"},
               .backend = "software",
               .device = "a device",
               .settings = {{"grid", grid}},
               .repeat = 3};
  row.figures = {.relative_l1 = error, .rmse = 2.0 * error, .flip_mean = 0.3};
  row.frame = {4.0, 3.0, 5.0};
  row.caustic = {2.0, 1.0, 2.5};
  row.texture_bytes = 1ull << 40;
  row.passes = {{"landing", 2, true, 1.5}, {"tone_map", 1, false, 0.25}};
  row.picture = "img/" + grid + ".png";
  return row;
}

Study study_of_two() {
  Study study;
  study.knobs = {{.key = "grid", .values = {"64", "128"}, .base = "64", .ordered = true}};
  study.identity = {{"scene", "ball"}, {"size", {4, 3}}};
  study.white = 123.5;
  study.planned = 2;
  study.rows = {row_with("64", 0.1), row_with("128", 1.0 / 3.0)};
  study.rows[1].problem = "out of \"memory\", twice";
  study.drifts = {{"software", 2.0, 2.25}};
  return study;
}

}  // namespace

TEST_CASE("study files: what is read back has the identity and the rows that were written") {
  const Study study = study_of_two();
  const auto back = read_study(study_json(study).dump());
  REQUIRE(back);
  CHECK(back->identity == study.identity);
  CHECK(back->white == study.white);
  REQUIRE(back->drifts.size() == 1);
  CHECK(back->drifts[0].backend == "software");
  CHECK(back->drifts[0].before == 2.0);
  CHECK(back->drifts[0].after == 2.25);
  // All but the point, which whoever goes on with it knows, and what is found once all rows are there.
  Study again = study;
  again.rows = back->rows;
  REQUIRE(again.rows.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) again.rows[i].point = study.rows[i].point;
  CHECK(study_json(again) == study_json(study));
  CHECK(study_csv(again) == study_csv(study));
}

TEST_CASE("study files: another format, and what is no study, is not read") {
  auto document = study_json(study_of_two());
  CHECK_FALSE(read_study(document.dump().substr(1)));
  CHECK_FALSE(read_study("[]"));
  document["rows"][1].erase("backend");
  CHECK_FALSE(read_study(document.dump()));
  document = study_json(study_of_two());
  document["format"] = document["format"].get<int>() + 1;
  CHECK_FALSE(read_study(document.dump()));
}

TEST_CASE("study files: a table's fields are quoted where a comma would part them") {
  const std::string table = study_csv(study_of_two());
  CHECK(table.rfind("group,backend,grid,relative_l1,", 0) == 0);
  CHECK(table.find(",img/128.png,\"out of \"\"memory\"\", twice\"\n") != std::string::npos);
  CHECK(table.find(
            "\ngrid,software,64,0.1,0.2,,,,,0.3,4.0,3.0,5.0,2.0,1.0,2.5,1099511627776,0,0,img/64.png,\n") !=
        std::string::npos);
}

TEST_CASE("study report: a row on the front is in the front's table, and one that is beaten is not") {
  Study study = study_of_two();
  study.rows[1].problem = "";
  study.rows[1].caustic.median = 1.0;  // errs by a third, but takes half of the first row's time
  study.rows.push_back(row_with("256", 0.5));
  judge(study);
  const std::string page = report_page(study, "no folder");
  const std::size_t from = page.find("<h2>What nothing beats"), to = page.find("<h2>", from + 1);
  REQUIRE((from != std::string::npos && to != std::string::npos));
  const std::string table = page.substr(from, to - from);
  CHECK(table.find("<td>64</td>") != std::string::npos);
  CHECK(table.find("<td>128</td>") != std::string::npos);
  CHECK(table.find("<td>256</td>") == std::string::npos);
}
