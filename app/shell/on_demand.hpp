// `render --target-error` and `--time-budget`: chooses the sizes of grid and maps for an error or a time that
// was asked for, from frames measured on this machine (docs/accuracy.md).
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/flux.hpp"
#include "app/frame.hpp"
#include "pipeline/measure/size_search.hpp"

namespace caustics::app {

// What a frame that has been run turned out to be. None where its light sees all around or throws no caustic.
std::optional<Trial> trial_of(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers,
                              double milliseconds);
// The error of all lights together, each weighed by its caustic's intensity.
ErrorEstimate error_of(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers);
double sum_of_passes(const std::vector<PassReport>& reports);

// A frame of the request with these sizes: its estimated error, and its passes' time, where that is demanded
// once memory is there.
std::optional<Trial> try_sizes(FrameRequest request, const Demand& demand, int grid, int map);

// What was asked for, chosen and found: a line. `only_model`: SizeSearch::only_model.
std::string demand_text(const Demand& demand, const Trial& found, bool only_model, double milliseconds);

// The pilots' sizes: the finer ones are twice as large.
inline constexpr int kPilotSide = 128;

// Renders small frames of the request to learn what sizes cost here. None where there is no caustic. Throws
// Error (WrongUsage) where a caustic's error cannot be told and the demand is for one.
std::optional<CostModel> measure_costs(const FrameRequest& request, const Demand& demand,
                                       const std::function<void(const std::string&)>& progress);

}  // namespace caustics::app
