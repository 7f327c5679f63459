// The figures of `caustics compare` as tables for people and as JSON.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/compare/measurement.hpp"
#include "app/compare/metric_bounds.hpp"

namespace caustics::app {

// Lines with a line break each; "" where nothing could be measured.
std::string measurement_text(const PlanesDifference& difference, const Measurement& measurement);
// Names and values; what does not exist is null.
nlohmann::ordered_json metrics_json(const ImageMetrics& metrics);
nlohmann::ordered_json layers_json(const Measurement& measurement);

// The line that decides under --fail-above: the bounds and what else fails. `fatal` is a reason
// beside the bounds, or "".
std::string bounds_line(const std::vector<BoundAnswer>& answers, const std::string& fatal);
nlohmann::ordered_json bounds_json(const std::vector<BoundAnswer>& answers);

}  // namespace caustics::app
