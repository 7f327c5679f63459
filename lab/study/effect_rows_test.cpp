#include "lab/study/effect_rows.hpp"

#include "tests/support/catch.hpp"

using namespace caustics::study;

namespace {

StudyRow row(const std::string& without, double error, double milliseconds) {
  StudyRow result;
  result.point = {{without}, kWithout};
  result.backend = "software";
  result.figures.relative_l1 = error;
  result.frame.median = milliseconds;
  return result;
}

Study study_of(std::vector<StudyRow> rows) {
  Study study;
  study.knobs = {{.key = kWithout, .values = {kNothing, "fresnel", "cells"}, .base = kNothing}};
  study.rows = std::move(rows);
  return study;
}

}  // namespace

TEST_CASE("effect rows: each stands beside the row that leaves nothing out, the most important first") {
  const Study study = study_of({row(kNothing, 0.25, 8.0), row("fresnel", 0.5, 7.5), row("cells", 0.75, 4.0)});
  CHECK(effects_csv(study) ==
        "effect,backend,error_with,error_without,milliseconds_with,milliseconds_without\n"
        "cells,software,0.25,0.75,8.0,4.0\n"
        "fresnel,software,0.25,0.5,8.0,7.5\n");
  CHECK(effects_json(study).size() == 2);
}

TEST_CASE("effect rows: what was not measured and studies of settings have none") {
  Study study = study_of({row(kNothing, 0.25, 8.0), row("fresnel", 0.5, 7.5)});
  study.rows[1].problem = "too large";
  CHECK(effect_rows(study).empty());
  study.rows[1].problem = "";
  CHECK(effect_rows(study).size() == 1);
  study.rows[0].figures.relative_l1.reset();
  CHECK(effect_rows(study).empty());
  study = study_of({row("64", 0.25, 8.0), row("128", 0.5, 7.5)});
  study.knobs[0].key = "grid";
  CHECK(effect_rows(study).empty());
}
