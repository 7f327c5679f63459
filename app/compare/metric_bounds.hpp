// --fail-above METRIC=VALUE: what a figure of `caustics compare` may be at most.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/compare/measurement.hpp"

namespace caustics::app {

struct MetricBound {
  std::string metric;
  double most = 0.0;

  bool is_of_flip() const { return metric.rfind("flip_", 0) == 0; }
};

// The metrics that can be bounded: those that grow with the error.
std::vector<std::string> boundable_metrics();

// "relative_l1=0.02"; throws Error (WrongUsage), which names the nearest metric.
MetricBound parse_metric_bound(const std::string& text);

// The worst layer under one bound.
struct BoundAnswer {
  MetricBound bound;
  bool applies = false;  // to any layer
  std::string layer;
  std::optional<double> value;  // none: the figure does not exist, which no bound allows
  bool holds = false;
};

// One for each bound. A bound of FLIP is about layers of colours.
std::vector<BoundAnswer> judge(const std::vector<MetricBound>& bounds, const Measurement& measurement);

}  // namespace caustics::app
