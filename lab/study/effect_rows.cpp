#include "lab/study/effect_rows.hpp"

#include <algorithm>

namespace caustics::study {

namespace {

double error_without(const EffectRow& row) { return *row.without->figures.relative_l1; }

bool measured(const StudyRow& row) { return row.problem.empty() && row.figures.relative_l1; }

// The row of this backend that leaves nothing out, or null.
const StudyRow* whole_row(const Study& study, const std::string& backend) {
  for (const StudyRow& row : study.rows)
    if (row.backend == backend && row.point.values.front() == kNothing && measured(row)) return &row;
  return nullptr;
}

}  // namespace

std::vector<EffectRow> effect_rows(const Study& study) {
  if (study.knobs.size() != 1 || study.knobs.front().key != kWithout) return {};
  std::vector<EffectRow> rows;
  for (const StudyRow& row : study.rows) {
    const StudyRow* whole = whole_row(study, row.backend);
    if (whole && &row != whole && measured(row))
      rows.push_back({row.point.values.front(), row.backend, whole, &row});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const EffectRow& a, const EffectRow& b) {
    return a.backend != b.backend ? a.backend > b.backend : error_without(a) > error_without(b);
  });
  return rows;
}

nlohmann::ordered_json effects_json(const Study& study) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const EffectRow& row : effect_rows(study))
    list.push_back({{"effect", row.effect},
                    {"backend", row.backend},
                    {"error_with", *row.with->figures.relative_l1},
                    {"error_without", error_without(row)},
                    {"milliseconds_with", row.with->frame.median},
                    {"milliseconds_without", row.without->frame.median}});
  return list;
}

std::string effects_csv(const Study& study) {
  std::string text = "effect,backend,error_with,error_without,milliseconds_with,milliseconds_without\n";
  for (const auto& row : effects_json(study)) {
    text += row["effect"].get<std::string>() + "," + row["backend"].get<std::string>();
    for (const char* figure : {"error_with", "error_without", "milliseconds_with", "milliseconds_without"})
      text += "," + row[figure].dump();
    text += "\n";
  }
  return text;
}

}  // namespace caustics::study
