// What follows from a study's rows: the fronts and the sentences.
#include <algorithm>

#include "lab/study/pareto.hpp"
#include "lab/study/sentence.hpp"
#include "lab/study/study.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::study {

namespace {

constexpr double kWorthwhile = 0.01;  // of the error

std::vector<std::size_t> front_indices(const Study& study, const std::string& backend) {
  std::vector<std::optional<Cost>> costs;
  for (const StudyRow& row : study.rows) {
    std::optional<Cost> cost;
    if (row.backend == backend && row.problem.empty() && row.figures.relative_l1)
      cost = Cost{*row.figures.relative_l1, row.caustic.median};
    costs.push_back(cost);
  }
  return pareto_front(costs, kWorthwhile);
}

// The row of a point, or null.
const StudyRow* row_of(const Study& study, const std::string& backend, const Point& point) {
  const auto found = std::find_if(study.rows.begin(), study.rows.end(), [&](const StudyRow& row) {
    return row.backend == backend && row.point.values == point.values;
  });
  return found == study.rows.end() ? nullptr : &*found;
}

}  // namespace

void judge(Study& study) {
  for (StudyRow& row : study.rows) {
    row.on_front = false;
    row.reference_limited =
        study.noise && row.figures.relative_l1 && *study.noise > *row.figures.relative_l1 / 3.0;
  }
  for (const std::string& backend : backends_of(study))
    for (const std::size_t i : front_indices(study, backend)) study.rows[i].on_front = true;
}

std::vector<const StudyRow*> front_of(const Study& study, const std::string& backend) {
  std::vector<const StudyRow*> front;
  for (const std::size_t i : front_indices(study, backend)) front.push_back(&study.rows[i]);
  return front;
}

std::vector<std::string> backends_of(const Study& study) {
  std::vector<std::string> backends;
  for (const StudyRow& row : study.rows)
    if (std::find(backends.begin(), backends.end(), row.backend) == backends.end())
      backends.push_back(row.backend);
  return backends;
}

std::vector<std::string> sentences_of(const Study& study) {
  const std::vector<std::string> backends = backends_of(study);
  std::vector<Point> points;
  for (const StudyRow& row : study.rows)
    if (std::find(points.begin(), points.end(), row.point) == points.end()) points.push_back(row.point);
  std::vector<std::string> sentences;
  for (const Step& step : steps(study.knobs, points)) {
    for (const std::string& backend : backends) {
      const StudyRow *from = row_of(study, backend, points[step.from]),
                     *to = row_of(study, backend, points[step.to]);
      if (!from || !to) continue;
      sentences.push_back((backends.size() > 1 ? backend + ": " : "") +
                          step_sentence(study.knobs[step.knob], step.knob, *from, *to));
    }
  }
  return sentences;
}

std::string drift_text(const Study& study, const Drift& drift) {
  const auto row = std::find_if(study.rows.begin(), study.rows.end(),
                                [&](const StudyRow& each) { return each.backend == drift.backend; });
  const std::string name = row == study.rows.end() ? "the first row" : point_text(study.knobs, row->point);
  return "The machine's drift (" + drift.backend + "): " + name + ", timed again at the end, took " +
         change_text(drift.before, drift.after) + " (" + short_number(drift.before) + " to " +
         short_number(drift.after) + " ms); smaller differences of time say little.";
}

std::string truth_text(const Study& study) {
  if (study.own_limit)
    return "Truth: " + study.truth +
           ". That is the program's own limit, not an independent truth: an error that "
           "all settings share does not show.";
  std::string text = "Truth: " + study.truth + ".";
  if (study.noise)
    return text + " Its own noise is " + short_number(*study.noise) +
           " (sum of caustic_error over sum of caustic); "
           "rows whose error is below three times that are marked reference-limited.";
  return text + " It says nothing of its own noise.";
}

}  // namespace caustics::study
