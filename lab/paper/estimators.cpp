// What finds where a ray lands.
#include <algorithm>
#include <cmath>

#include "lab/paper/floor_shots.hpp"
#include "lab/paper/measures.hpp"
#include "lab/paper/rows.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::paper {

namespace {

const std::vector<std::string> kEstimators{"paper", "newton", "impostor", "secant"};
// The paper's own frame, but for what hides the estimators: a fine grid, cells, and light that it lets in.
const Options kPaperEstimates{"--preset", "paper", "--grid",    "512",
                              "--splat",  "cell",  "--weights", "physical"};
const std::vector<std::string> kLandingToMap{"landing", "caustic_map"};

Options with_estimator(Options options, const std::string& estimator) {
  options.insert(options.end(), {"--estimator", estimator});
  return options;
}

// What light takes from the caster to the map on all processors together, the least of three frames whose
// picture does not matter.
double milliseconds_of(const Shots& s, const std::string& estimator) {
  double least = 1e30;
  for (const char* n : {"1", "2", "3"})
    least = std::min(least, s.milliseconds("time_" + estimator + n, kLandingToMap, "processor_milliseconds"));
  return least;
}

Shot timed(const std::string& estimator, const std::string& n) {
  Options options = with_estimator({"--preset", "paper", "--grid", "512", "-r", "32x32"}, estimator);
  return {"time_" + estimator + n, "glass_sphere.glb", options};
}

Finding judge_estimators(const Shots& s) {
  const auto error = [&](const std::string& shot) { return s.relative_l1(shot, "sphere_traced", "caustic"); };
  std::string text = "relative L1, all with Wyman's exit, nothing dropped:";
  double nearest = 1e30;
  for (const std::string& e : kEstimators) {
    nearest = std::min(nearest, error("estimator_" + e));
    text += " " + e + " " + percent(error("estimator_" + e)) + ",";
  }
  const double paper = milliseconds_of(s, "paper"), impostor = milliseconds_of(s, "impostor");
  const double beyond = error("estimator_beyond");
  text += " landing and map take " + duration_text(paper) + " of processors by the paper's, " +
          duration_text(impostor) + " by impostors, " + significant(impostor / paper, 3) +
          " times the paper's (245 fps / 160 fps in the paper: 1.53); the preset as it stands (points, grid "
          "128) " +
          percent(error("preset")) + "; beyond the paper, the secant's exit: " + percent(beyond);
  s.draw_side_by_side({"estimator_impostor", "estimator_paper", "preset", "estimator_beyond"},
                      "sphere_traced", "caustic", "estimators_side_by_side");
  return {beyond < 0.5 * nearest && impostor > paper &&
              std::fabs(error("estimator_paper") - error("estimator_impostor")) < 0.05,
          text};
}

}  // namespace

Row estimators_row() {
  Row row{
      "5, 31, 32",
      "Fig. 6: distance impostors, the paper's estimator (the modified version), Newton's (the appendix); "
      "beside traced light",
      {traced_floor("sphere_traced", "glass_sphere.glb")},
      "estimators_side_by_side",
      "3 iterations and one exit for all: the paper's lies within 5 points of impostors and takes less time; "
      "the secant's exit halves the error",
      judge_estimators};
  for (const std::string& e : kEstimators) {
    row.shots.push_back(floor_shot("estimator_" + e, "glass_sphere.glb", with_estimator(kPaperEstimates, e)));
    if (e != "paper" && e != "impostor") continue;
    for (const char* n : {"1", "2", "3"}) row.shots.push_back(timed(e, n));
  }
  row.shots.push_back(floor_shot("preset", "glass_sphere.glb", {"--preset", "paper"}));
  row.shots.push_back(floor_shot("estimator_beyond", "glass_sphere.glb", {"--iterations", "3"}));
  return row;
}

Row receivers_row() {
  const Options view{"--camera", "floor", "-r", "360x360"};
  Row row{"6, 33, 38",
          "Figs. 6, 7: caustics mapping and distance impostors beside offline tracing, and receivers of any "
          "shape",
          {{.name = "receivers_traced", .scene = "receivers.glb", .options = view, .traced = true}},
          "receivers_side_by_side",
          "3 iterations and one exit for all, step, ball and ramp; beyond the paper, the secant's exit is "
          "nearer to "
          "traced light than all of them",
          {}};
  row.shots.front().options.insert(row.shots.front().options.end(), {"--batches", "48"});
  const auto add = [&](const std::string& name, const Options& options) {
    Shot shot{"receivers_" + name, "receivers.glb", view, "caustic"};
    shot.options.insert(shot.options.end(), options.begin(), options.end());
    row.shots.push_back(shot);
  };
  for (const std::string& e : kEstimators) add(e, with_estimator(kPaperEstimates, e));
  add("beyond", {"--iterations", "3", "-D", "further.share=1"});
  row.check = [](const Shots& s) -> Finding {
    const auto error = [&](const std::string& e) {
      return s.relative_l1("receivers_" + e, "receivers_traced", "caustic");
    };
    std::string text = "relative L1:";
    bool holds = true;
    for (const std::string& e : kEstimators) {
      text += " " + e + " " + percent(error(e)) + ",";
      holds = holds && error("beyond") < error(e);
    }
    s.draw_side_by_side({"receivers_impostor", "receivers_paper", "receivers_newton", "receivers_beyond"},
                        "receivers_traced", "caustic", "receivers_side_by_side");
    return {holds, text + " the secant's exit " + percent(error("beyond"))};
  };
  return row;
}

Row reflection_row() {
  Row row{"28",
          "better on refraction than on reflection",
          {},
          "",
          "the paper's estimator, 3 iterations: its landings on water's bed lie nearer to the secant's than "
          "those "
          "of a metal ring",
          {}};
  for (const char* scene : {"water_patch", "metal_ring"})
    for (const char* estimator : {"paper", "secant"})
      row.shots.push_back(
          dumped_shot(std::string(scene) + "_" + estimator, std::string(scene) + ".glb", 256,
                      {"--estimator", estimator, "--iterations",
                       estimator == std::string("paper") ? "3" : "8", "-D", "unconverged=draw"}));
  row.check = [](const Shots& s) -> Finding {
    const auto mean = [&](const std::string& scene) {
      const std::vector<double> apart = distances(s.attachment(scene + "_paper", "landing[0]"),
                                                  s.attachment(scene + "_secant", "landing[0]"));
      double sum = 0.0;
      for (const double d : apart) sum += d;
      return sum / std::max<double>(1.0, static_cast<double>(apart.size()));
    };
    const double water = mean("water_patch"), ring = mean("metal_ring");
    return {water < ring, "mean distance of landings: water " + significant(1e3 * water, 2) + " mm, ring " +
                              significant(1e3 * ring, 2) + " mm"};
  };
  return row;
}

Row visibility_row() {
  return {"29",
          "discontinuous receivers: what lands and what does not",
          {{.name = "receivers_traced",
            .scene = "receivers.glb",
            .options = {"--camera", "floor", "-r", "360x360", "--batches", "48"},
            .traced = true},
           {"receivers_default",
            "receivers.glb",
            {"--camera", "floor", "-r", "360x360", "-D", "further.share=1"},
            "caustic"}},
          "receivers_default",
          "as much of the light lands on step, ball, ramp and floor as of traced light, within 1 %",
          [](const Shots& s) -> Finding {
            const double ours = s.share("receivers_default", "in_map"),
                         truth = s.share("receivers_traced", "landed");
            return {std::fabs(ours - truth) < 0.01,
                    percent(ours) + " lands, of traced light " + percent(truth) + "; not converged " +
                        percent(s.share("receivers_default", "not_converged"))};
          }};
}

Row secant_row() {
  return {
      "35",
      "future work: a better estimator (participating media: row 30)",
      {dumped_shot("slab_secant", "slab_glass.glb", 64, {"--iterations", "1"}),
       dumped_shot("slab_paper", "slab_glass.glb", 64,
                   {"--preset", "paper", "--iterations", "1", "-D", "thickness=map"})},
      "",
      "one step of the secant is exact on planes: 1e-5 m",
      [](const Shots& s) -> Finding {
        const auto worst = [&](const std::string& name) {
          return percentile(
              slab_errors(kSlab, s.attachment(name, "caster_position[0]"), s.attachment(name, "landing[0]")),
              1.0);
        };
        const double secant = worst("slab_secant"), paper = worst("slab_paper");
        return {secant < 1e-5, "through a slab onto a floor, at most: the secant " + significant(secant, 2) +
                                   " m, the paper's " + significant(1e3 * paper, 2) + " mm"};
      }};
}

Row tolerance_row() {
  return {"36",
          "it tolerates a certain amount of error",
          {dumped_shot("tolerance_paper", "glass_sphere.glb", 128, {"--preset", "paper", "--grid", "128"}),
           dumped_shot("tolerance_secant", "glass_sphere.glb", 128)},
          "",
          "landings against the closed form: the middle one within a texel of the receiver map, the secant's "
          "95 % "
          "within two",
          [](const Shots& s) -> Finding {
            const auto errors = [&](const std::string& name) {
              return sphere_errors(kSphere, s.attachment(name, "caster_position[0]"),
                                   s.attachment(name, "landing[0]"));
            };
            const Texels floor = s.attachment("tolerance_secant", "receiver_position[0]");
            const double texel = std::fabs(floor.values[1][0] - floor.values[0][0]);
            const std::vector<double> paper = errors("tolerance_paper"), secant = errors("tolerance_secant");
            const auto text = [&](const std::vector<double>& e) {
              return significant(percentile(e, 0.5) / texel, 2) + " and " +
                     significant(percentile(e, 0.95) / texel, 2);
            };
            return {percentile(secant, 0.5) < texel && percentile(secant, 0.95) < 2.0 * texel,
                    "median and 95th percentile in texels of " + significant(1e3 * texel, 2) +
                        " mm: secant " + text(secant) + ", preset paper " + text(paper)};
          }};
}
}  // namespace caustics::paper
