#include "app/compare/metric_bounds.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/output/image_layers.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/nearest.hpp"

namespace caustics::app {

namespace {

std::optional<double> figure(const LayerMeasure& layer, const std::string& metric) {
  for (const NamedMetric& each : named_metrics(layer)) {
    if (each.name == metric) return each.value;
  }
  return std::nullopt;
}

bool has_colors(const LayerMeasure& layer) {
  return std::any_of(layer.channels.begin(), layer.channels.end(),
                     [](const ChannelDifference* each) { return is_color(each->name); });
}

// None is the worst.
bool is_worse(const std::optional<double>& value, const std::optional<double>& than) {
  if (!than) return false;
  return !value || *value > *than;
}

BoundAnswer judge_bound(const MetricBound& bound, const Measurement& measurement) {
  BoundAnswer answer;
  answer.bound = bound;
  for (const LayerMeasure& layer : measurement.layers) {
    if (bound.is_of_flip() && !has_colors(layer)) continue;
    const std::optional<double> value = figure(layer, bound.metric);
    if (answer.applies && !is_worse(value, answer.value)) continue;
    answer.layer = layer.layer;
    answer.value = value;
    answer.applies = true;
  }
  answer.holds = answer.value && *answer.value <= bound.most;
  return answer;
}

}  // namespace

std::vector<std::string> boundable_metrics() {
  std::vector<std::string> names;
  for (const NamedMetric& each : named_metrics(LayerMeasure{})) {
    if (each.grows_with_error) names.push_back(each.name);
  }
  return names;
}

MetricBound parse_metric_bound(const std::string& text) {
  const std::size_t split = text.find('=');
  const std::string metric = text.substr(0, split);
  const std::vector<std::string> names = boundable_metrics();
  if (std::find(names.begin(), names.end(), metric) == names.end()) {
    throw Error(ExitCode::WrongUsage,
                "--fail-above knows no metric " + in_quotes(metric) + suggestion(metric, names));
  }
  const std::string number = split == std::string::npos ? "" : text.substr(split + 1);
  MetricBound bound{.metric = metric};
  const char* end = number.data() + number.size();
  const auto result = std::from_chars(number.data(), end, bound.most);
  if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(bound.most) || bound.most < 0.0) {
    throw Error(ExitCode::WrongUsage, "--fail-above " + metric + " cannot be " + in_quotes(number) + ": " +
                                          metric + "=NUMBER, 0 or more");
  }
  return bound;
}

std::vector<BoundAnswer> judge(const std::vector<MetricBound>& bounds, const Measurement& measurement) {
  std::vector<BoundAnswer> answers;
  answers.reserve(bounds.size());
  for (const MetricBound& bound : bounds) answers.push_back(judge_bound(bound, measurement));
  return answers;
}

}  // namespace caustics::app
