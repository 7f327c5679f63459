#include "app/study_text.hpp"

#include "app/shell/table.hpp"
#include "lab/study/effect_rows.hpp"
#include "lab/study/sentence.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::app {

using namespace study;

namespace {

std::string remark(const StudyRow& row) { return row.reference_limited ? "reference-limited" : ""; }

std::string front_table(const Study& study, const std::string& backend) {
  Table table({false, true, true, true, true, true, true});
  table.row({"setting", "relative L1", "relMSE 1", "flux", "FLIP", "ms caustic", "ms frame", ""});
  for (const StudyRow* row : front_of(study, backend)) {
    const Figures& f = row->figures;
    table.row({point_text(study.knobs, row->point), figure_text(f.relative_l1), figure_text(f.relative_mse_1),
               ratio_text(f.flux_ratio), figure_text(f.flip_mean), short_number(row->caustic.median),
               short_number(row->frame.median), remark(*row)});
  }
  return table.text();
}

std::string effect_table(const Study& study) {
  Table table({false, false, true, true, true, true});
  table.row({"effect", "", "error with", "without", "ms with", "without"});
  for (const EffectRow& row : effect_rows(study))
    table.row({row.effect, row.backend, figure_text(row.with->figures.relative_l1),
               figure_text(row.without->figures.relative_l1), short_number(row.with->frame.median),
               short_number(row.without->frame.median)});
  return "\nwhat each effect brings, error relative L1, time of all passes:\n" + table.text();
}

std::string base_words(const Study& study) {
  std::string text;
  for (const Knob& knob : study.knobs) text += (text.empty() ? "" : ", ") + knob.key + " " + knob.base;
  return text;
}

}  // namespace

std::string report_text(const Study& study) {
  std::string text = one_line(study.scene) + ", " + std::to_string(study.width) + "x" +
                     std::to_string(study.height) + ", " + std::to_string(study.rows.size()) + " of " +
                     std::to_string(study.planned) + " rows\n" + truth_text(study) +
                     "\nbase: " + base_words(study) + "\n";
  if (!effect_rows(study).empty()) text += effect_table(study);
  for (const std::string& backend : backends_of(study))
    text += "\nnothing beats these in both error and time (" + backend + "):\n" + front_table(study, backend);
  text += "\nknob by knob, error relative L1, time of the caustic passes:\n";
  for (const std::string& sentence : sentences_of(study)) text += "  " + sentence + "\n";
  for (const Drift& drift : study.drifts) text += drift_text(study, drift) + "\n";
  for (const StudyRow& row : study.rows)
    if (!row.problem.empty())
      text += "  " + point_text(study.knobs, row.point) + " (" + row.backend + "): not measured, " +
              row.problem + "\n";
  return text;
}

}  // namespace caustics::app
