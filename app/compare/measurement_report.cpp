#include "app/compare/measurement_report.hpp"

#include "app/json.hpp"
#include "app/shell/table.hpp"
#include "app/shell/terminal.hpp"

namespace caustics::app {

namespace {

std::string shown(const std::optional<double>& value) { return value ? significant(*value, 4) : "-"; }

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

// "layer caustic", "the layer without a name".
std::string layer_text(const std::string& layer) {
  return layer.empty() ? "the layer without a name" : "layer " + one_line(layer);
}

std::vector<std::string> figures_row(const std::string& name, const ImageMetrics& m) {
  std::vector<std::string> row = {name, shown(m.relative_l1), shown(m.rmse)};
  for (const auto& each : m.relative_mse) row.push_back(shown(each));
  for (const auto& each : m.clipped) row.push_back(shown(each));
  row.push_back(shown(m.flux_ratio));
  row.push_back(shown(m.psnr));
  return row;
}

// "caustic (R, G, B)".
std::string channels_text(const LayerMeasure& layer) {
  std::string names;
  for (const ChannelDifference* channel : layer.channels) {
    const std::string& name = channel->name;
    names += (names.empty() ? "" : ", ") + one_line(name.substr(name.rfind('.') + 1));
  }
  return one_line(layer.layer) + (layer.layer.empty() ? "(" : " (") + names + ")";
}

std::string flip_text(const LayerMeasure& layer) {
  const std::string name = layer_text(layer.layer);
  if (!layer.flip) return "FLIP: " + name + " " + layer.no_flip + "\n";
  const FlipFigures& f = layer.flip->figures;
  return "FLIP of " + name + ": mean " + significant(f.mean, 4) + ", weighted median " +
         significant(f.median, 4) + " (quartiles " + significant(f.first_quartile, 4) + ", " +
         significant(f.third_quartile, 4) + "), largest " + significant(f.largest, 4) +
         (layer.flip->exposure ? "; exposure " + significant(*layer.flip->exposure, 4) : "; display values") +
         "\n";
}

std::string selection_text(const Selection& selection) {
  if (selection.all()) return "";
  return grouped(selection.texels) + " of " + grouped(selection.mask.size()) +
         " texels are selected; nothing else is looked at\n";
}

std::string answer_text(const BoundAnswer& answer) {
  if (!answer.applies) {
    return answer.bound.metric + " is of no layer here, bound " + significant(answer.bound.most, 6);
  }
  return answer.bound.metric + " of " + layer_text(answer.layer) + " is " +
         (answer.value ? significant(*answer.value, 4) : "undefined") + ", bound " +
         significant(answer.bound.most, 6);
}

Json flip_json(const LayerFlip& flip) {
  const FlipFigures& f = flip.figures;
  return {{"mean", f.mean},
          {"first_quartile", f.first_quartile},
          {"median", f.median},
          {"third_quartile", f.third_quartile},
          {"maximum", f.largest},
          {"exposure", number(flip.exposure)},
          {"pixels_per_degree", kFlipPixelsPerDegree}};
}

}  // namespace

std::string measurement_text(const PlanesDifference& difference, const Measurement& measurement) {
  if (measurement.layers.empty()) return "";
  Table table({false, true, true, true, true, true, true, true, true, true, true});
  table.row({"A from B", "relative L1", "RMSE", "relMSE 1", "4", "16", "clipped 1", "4", "16", "flux A/B",
             "PSNR dB"});
  for (std::size_t i = 0; i < difference.channels.size(); ++i) {
    const ChannelDifference& channel = difference.channels[i];
    if (!channel.mismatch.empty()) continue;
    table.row(figures_row(one_line(channel.name), measurement.channels[i]));
  }
  std::string flip;
  for (const LayerMeasure& layer : measurement.layers) {
    if (layer.channels.size() > 1) table.row(figures_row(channels_text(layer), layer.metrics));
    if (measurement.has_flip) flip += flip_text(layer);
  }
  return selection_text(measurement.selection) + table.text() + flip;
}

Json metrics_json(const ImageMetrics& metrics) {
  Json json = {{"values", metrics.values}, {"non_finite", metrics.non_finite}};
  for (const NamedMetric& each : named_metrics(metrics)) json[each.name] = number(each.value);
  json["clip"] = number(metrics.clip);
  return json;
}

Json layers_json(const Measurement& measurement) {
  Json list = Json::array();
  for (const LayerMeasure& layer : measurement.layers) {
    Json json = {{"layer", layer.layer}, {"channels", Json::array()}};
    for (const ChannelDifference* each : layer.channels) json["channels"].push_back(each->name);
    json["metrics"] = metrics_json(layer.metrics);
    if (measurement.has_flip) json["flip"] = layer.flip ? flip_json(*layer.flip) : Json(nullptr);
    list.push_back(json);
  }
  return list;
}

std::string bounds_line(const std::vector<BoundAnswer>& answers, const std::string& fatal) {
  std::string beyond, within;
  for (const BoundAnswer& each : answers) {
    std::string& list = each.holds ? within : beyond;
    list += (list.empty() ? "" : "; ") + answer_text(each);
  }
  if (!fatal.empty()) beyond = fatal + (beyond.empty() ? "" : "; ") + beyond;
  if (!beyond.empty()) return "beyond the bounds: " + beyond + "\n";
  return "within the bounds: " + within + "\n";
}

Json bounds_json(const std::vector<BoundAnswer>& answers) {
  Json list = Json::array();
  for (const BoundAnswer& each : answers) {
    list.push_back({{"metric", each.bound.metric},
                    {"bound", each.bound.most},
                    {"layer", each.applies ? Json(each.layer) : Json(nullptr)},
                    {"value", number(each.value)},
                    {"holds", each.holds}});
  }
  return list;
}

}  // namespace caustics::app
