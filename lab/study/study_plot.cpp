#include "lab/study/study_plot.hpp"

#include <algorithm>

#include "lab/study/sentence.hpp"

namespace caustics::study {

namespace {

// The page's colours on white, without variables, which not all viewers of SVG files know.
constexpr char kFileStyle[] = R"(<style>
text { fill: #1b1b1b; font: 13px sans-serif; } .gridline { stroke: #d8d8d8; } .leader { stroke: #1b1b1b;
  stroke-width: .6; }
.floor { stroke: #1b1b1b; stroke-dasharray: 2 4; } .front { stroke: #1b1b1b; fill: none; stroke-width: 1.6; }
.dashed { stroke-dasharray: 7 5; } .mark { stroke-width: 2; } .spread { stroke-width: 1; }
.g0 { stroke: #0063a6; fill: #0063a6; } .g1 { stroke: #b4460f; fill: #b4460f; } .g2 { stroke: #117a55;
  fill: #117a55; }
.g3 { stroke: #a03c84; fill: #a03c84; } .g4 { stroke: #8a6500; fill: #8a6500; } .g5 { stroke: #2b7aa8;
  fill: #2b7aa8; }
.g6 { stroke: #b3261e; fill: #b3261e; } .g7 { stroke: #55555a; fill: #55555a; } .hollow { fill: #fff; }
</style>
<rect width="100%" height="100%" fill="#fff"/>
)";

bool drawable(const StudyRow& row) {
  return row.problem.empty() && row.figures.relative_l1 && *row.figures.relative_l1 > 0.0 &&
         row.caustic.least > 0.0;
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
                           name + " (" + row.backend + "): relative L1 " +
                               figure_text(row.figures.relative_l1) + ", " +
                               short_number(row.caustic.median) + " ms",
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

std::string plot_file(const Study& study) {
  const Plot plot = plot_of(study);
  if (plot.points.empty()) return {};
  std::string svg = draw(plot);
  return svg.insert(svg.find('>') + 2, kFileStyle);
}

}  // namespace caustics::study
