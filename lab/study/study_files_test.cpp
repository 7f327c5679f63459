// What a study writes of itself, and reads back.
#include <map>

#include "lab/study/report_page.hpp"
#include "lab/study/sentence.hpp"
#include "lab/study/study.hpp"
#include "lab/study/study_plot.hpp"
#include "pipeline/gpu/text.hpp"
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

// What stands between each `<tag ...>` and the next `</tag>`.
std::vector<std::string> insides(const std::string& html, const std::string& tag) {
  std::vector<std::string> found;
  for (std::size_t at = html.find("<" + tag); at != std::string::npos; at = html.find("<" + tag, at + 1)) {
    const char after = html[at + tag.size() + 1];
    if (after != '>' && after != ' ') continue;  // another tag, as <thead> is none of <th>
    const std::size_t from = html.find('>', at) + 1;
    found.push_back(html.substr(from, html.find("</" + tag + ">", from) - from));
  }
  return found;
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

TEST_CASE(
    "study report: each row of a table has a cell below each head, with the row's number of that name") {
  Study study = study_of_two();
  for (StudyRow& row : study.rows) {
    const double scale = row.point.values[0] == "64" ? 1.0 : 3.0;
    row.problem = "";
    row.figures = {.relative_l1 = 0.011 * scale,
                   .flux_ratio = 1.0 + 0.01 * scale,
                   .flip_mean = 0.012 * scale,
                   .relative_mse_1 = 0.013 * scale,
                   .relative_mse_4 = 0.014 * scale,
                   .relative_mse_16 = 0.015 * scale};
    row.frame.median = 16.0 * scale;
    row.caustic.median = 17.0 * scale;
    row.texture_bytes = static_cast<std::uint64_t>(18'000'000.0 * scale);
  }
  judge(study);
  const std::string page = report_page(study, "no folder");
  for (const std::string& table : insides(page, "table")) {
    const std::vector<std::string> rows = insides(table, "tr");
    const std::vector<std::string> heads = insides(rows.at(0), "th");
    INFO(table);
    for (std::size_t r = 1; r < rows.size(); ++r) {
      const std::vector<std::string> cells = insides(rows[r], "td");
      REQUIRE(cells.size() == heads.size());
      std::map<std::string, std::string> by_head;
      for (std::size_t i = 0; i < cells.size(); ++i) by_head[heads[i]] = cells[i];
      if (!by_head.count("textures")) continue;
      const double scale = by_head.at("grid") == "64" ? 1.0 : 3.0;
      CHECK(by_head.at("backend") == "software");
      CHECK(by_head.at("relative L1") == short_number(0.011 * scale));
      CHECK(by_head.at("flux") == ratio_text(1.0 + 0.01 * scale));
      CHECK(by_head.at("FLIP") == short_number(0.012 * scale));
      CHECK(by_head.at("relMSE 1") == short_number(0.013 * scale));
      CHECK(by_head.at("relMSE 4") == short_number(0.014 * scale));
      CHECK(by_head.at("relMSE 16") == short_number(0.015 * scale));
      CHECK(by_head.at("ms frame") == short_number(16.0 * scale));
      CHECK(by_head.at("ms caustic") == short_number(17.0 * scale));
      CHECK(by_head.at("textures") == caustics::bytes_text(18e6 * scale));
    }
  }
}

TEST_CASE("study report: what was not measured has no times and no bytes, but its reason") {
  const std::string page = report_page(study_of_two(), "no folder");
  const std::size_t from = page.find("<h2>All rows");
  REQUIRE(from != std::string::npos);
  const std::vector<std::string> rows = insides(insides(page.substr(from), "table").at(0), "tr");
  REQUIRE(rows.size() == 3);
  for (const std::size_t r : {1u, 2u}) {
    const std::vector<std::string> cells = insides(rows[r], "td");
    REQUIRE(cells.size() == 12);
    for (std::size_t i = 8; i < 11; ++i) CHECK((cells[i] == "n/a") == (r == 2));
    CHECK((cells[11].find("not measured: out of ") == 0) == (r == 2));
  }
}

TEST_CASE("study plot: a point's words are its row's settings, backend, error and time, on every backend") {
  Study study = study_of_two();
  study.rows[1].problem = "";
  for (const std::size_t i : {0u, 1u}) {
    study.rows.push_back(study.rows[i]);
    study.rows.back().backend = "gl";
  }
  for (std::size_t i = 0; i < study.rows.size(); ++i)
    study.rows[i].caustic.median = 2.0 + static_cast<double>(i);
  judge(study);
  const Plot plot = plot_of(study);
  REQUIRE(plot.points.size() == 4);
  const char* const expected[] = {
      "base (software): relative L1 0.1, 2 ms", "grid 128 (software): relative L1 0.333, 3 ms",
      "base (gl): relative L1 0.1, 4 ms", "grid 128 (gl): relative L1 0.333, 5 ms"};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(plot.points[i].title == expected[i]);
    CHECK(plot.points[i].hollow == (i > 1));
    CHECK(plot.points[i].label == (i % 2 == 0 ? "base" : ""));
  }
}
