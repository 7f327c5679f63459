#include "app/study/study_plot.hpp"

#include <algorithm>

#include "app/study/sentence.hpp"

namespace caustics::app {

namespace {

bool drawable(const StudyRow& row) {
  return row.problem.empty() && row.figures.relative_l1 && *row.figures.relative_l1 > 0.0 && row.caustic.least > 0.0;
}

std::size_t group_of(Plot& plot, const std::string& name) {
  const auto found = std::find(plot.groups.begin(), plot.groups.end(), name);
  if (found != plot.groups.end()) return static_cast<std::size_t>(found - plot.groups.begin());
  plot.groups.push_back(name);
  return plot.groups.size() - 1;
}

}  // namespace

Plot plot_of(const Study& study) {
  Plot plot{.title = "Error against time of every row; all of its numbers are in the table of all rows",
            .x_name = "milliseconds of the caustic passes, median of a row's frames (bar: least and most)",
            .y_name = "relative L1"};
  const std::vector<std::string> backends = backends_of(study);
  for (std::size_t b = 0; b < backends.size(); ++b) {
    const std::string hollow = b > 0 ? ", hollow marks" : "";
    plot.fronts.push_back({backends[b] + hollow + ": nothing is better in both", b > 0, {}});
  }
  std::vector<const StudyRow*> shown;
  for (const StudyRow& row : study.rows) {
    if (!drawable(row)) continue;
    const std::string name = point_text(study.knobs, row.point);
    const bool hollow = !backends.empty() && row.backend != backends.front();
    plot.points.push_back({row.caustic.median, *row.figures.relative_l1, row.caustic.least, row.caustic.most,
                           group_of(plot, row.point.group), hollow,
                           name + " (" + row.backend + "): relative L1 " + figure_text(row.figures.relative_l1) +
                               ", " + short_number(row.caustic.median) + " ms",
                           row.on_front ? name : ""});
    shown.push_back(&row);
  }
  for (std::size_t b = 0; b < backends.size(); ++b) {
    for (const StudyRow* row : front_of(study, backends[b])) {
      const auto at = std::find(shown.begin(), shown.end(), row);
      if (at != shown.end()) plot.fronts[b].points.push_back(static_cast<std::size_t>(at - shown.begin()));
    }
  }
  if (study.noise && *study.noise > 0.0) {
    plot.floor = *study.noise;
    plot.floor_name = "the truth's own noise";
  }
  return plot;
}

}  // namespace caustics::app
