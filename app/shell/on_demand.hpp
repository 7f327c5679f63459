// `render --target-error` and `--time-budget`: chooses the sizes of grid and maps for an error or a time that
// was asked for, from frames measured on this machine (docs/accuracy.md).
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/flux.hpp"
#include "app/frame.hpp"
#include "pipeline/measure/cost_model.hpp"

namespace caustics::app {

// What a frame that has been run turned out to be. None where its light sees all around or throws no caustic.
std::optional<Trial> trial_of(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers,
                              double milliseconds);
// Of all lights together, in lumens.
ErrorEstimate error_of(const Scene& scene, const std::vector<LightLedger>& ledgers);
double sum_of_passes(const std::vector<PassReport>& reports);

// A frame of the request with these sizes: its estimated error, and its passes' time once memory is there.
std::optional<Trial> try_sizes(FrameRequest request, int grid, int map);

// What was asked for, chosen, expected and found: a line.
std::string demand_text(const Demand& demand, const Trial& expected, const Trial& found, double milliseconds);

// The pilots' sizes: the finer ones are twice as large.
inline constexpr int kPilotSide = 128;

// Renders small frames of the request to learn what sizes cost here. None where there is no caustic. Throws
// Error (WrongUsage) where a caustic's error cannot be told and the demand is for one.
std::optional<CostModel> measure_costs(const FrameRequest& request, const Demand& demand,
                                       const std::function<void(const std::string&)>& progress);

}  // namespace caustics::app
