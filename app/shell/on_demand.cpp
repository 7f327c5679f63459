#include "app/shell/on_demand.hpp"

#include <algorithm>

#include "app/frame_options.hpp"
#include "app/loaded_scene.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::app {

std::optional<Trial> try_sizes(FrameRequest request, const Demand& demand, int grid, int map) {
  request.settings.grid = grid;
  request.settings.map = map;
  request.backend.measure = true;
  RenderedFrame frame(request, load_scene(request), goal_with_ledgers({"picture"}));
  LedgerReader reader;
  double milliseconds = sum_of_passes(frame.run(reader.watch(frame)));
  // The first run also fetches memory, which later frames have.
  if (demand.milliseconds) {
    milliseconds = sum_of_passes(frame.run());
    milliseconds = std::min(milliseconds, sum_of_passes(frame.run()));
  }
  return trial_of(frame, reader.ledgers(), milliseconds);
}

std::string demand_text(const Demand& demand, const Trial& found, bool only_model, double milliseconds) {
  const std::string asked = demand.error ? "an error of " + significant(100.0 * *demand.error, 3) + "%"
                                         : "passes within " + duration_text(*demand.milliseconds);
  const std::string model = only_model ? ", of which " + percent(found.model) +
                                             " is light that takes ways which are not followed, whatever the "
                                             "sizes"
                                       : "";
  return std::string(meets(found, demand) ? "" : "missed: ") + "asked for " + asked + ": chose --grid " +
         std::to_string(found.grid) + " --map " + std::to_string(found.map) + ", found " +
         percent(found.error()) + model + " in " + duration_text(found.milliseconds) + " (choosing took " +
         duration_text(milliseconds) + ")\n";
}

double sum_of_passes(const std::vector<PassReport>& reports) {
  double sum = 0.0;
  for (const PassReport& report : reports) sum += report.result.milliseconds;
  return sum;
}

ErrorEstimate error_of(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers) {
  ErrorEstimate all;
  for (const LightLedger& entry : ledgers) {
    const glm::dvec3 intensity = caustic_intensity_of(frame, entry.light);
    add(all, entry.error, (intensity.x + intensity.y + intensity.z) / 3.0);
  }
  return all;
}

std::optional<Trial> trial_of(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers,
                              double milliseconds) {
  const ErrorEstimate error = error_of(frame, ledgers);
  if (!(error.landed > 0.0)) return {};
  return Trial{.grid = frame.settings().grid,
               .map = frame.settings().map,
               .map_error = error.relative(error.map),
               .grid_error = error.relative(error.grid),
               .missing = error.relative(error.missing),
               .model = error.relative(error.model),
               .milliseconds = milliseconds};
}

std::optional<CostModel> measure_costs(const FrameRequest& request, const Demand& demand,
                                       const std::function<void(const std::string&)>& progress) {
  std::vector<Trial> trials;
  for (const auto& [grid, map] : {std::pair(kPilotSide, kPilotSide), std::pair(2 * kPilotSide, kPilotSide),
                                  std::pair(kPilotSide, 2 * kPilotSide)}) {
    progress("measuring what accuracy costs here: " + std::to_string(trials.size() + 1) + " of 3");
    const std::optional<Trial> trial = try_sizes(request, demand, grid, map);
    if (!trial) {
      if (demand.error && effects_of(load_scene(request)->scene(), request.settings).caustics.active)
        throw Error(ExitCode::WrongUsage,
                    "--target-error: the error of this caustic cannot be told, as none of its "
                    "light lands, or as points that see all around; choose --grid and --map");
      return {};
    }
    trials.push_back(*trial);
  }
  return CostModel(trials[0], trials[1], trials[2]);
}

}  // namespace caustics::app
