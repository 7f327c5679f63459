#include <cmath>

#include "app/compare/difference_report.hpp"
#include "app/compare/measurement_report.hpp"
#include "app/json.hpp"
#include "app/output/stats.hpp"
#include "app/shell/version.hpp"

namespace caustics::app {

namespace {

// JSON has no word for these values; a reader must not take them for a missing one.
Json number(float value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0.0f ? "inf" : "-inf";
  return value;
}

Json spread_json(const Spread& spread) {
  return {{"maximum", spread.largest}, {"p999", spread.p999}, {"mean", spread.mean}};
}

Json ulps_json(const Spread& spread) {
  return {{"maximum", static_cast<std::uint64_t>(spread.largest)},
          {"p999", static_cast<std::uint64_t>(spread.p999)},
          {"mean", spread.mean}};
}

Json pair_json(const std::optional<ValuePair>& pair) {
  if (!pair) return nullptr;
  return {{"x", pair->x}, {"y", pair->y}, {"a", number(pair->a)}, {"b", number(pair->b)}};
}

Json channel_json(const ChannelDifference& channel) {
  Json json = {{"channel", channel.name}, {"verdict", name_of(channel.verdict())}};
  if (!channel.mismatch.empty()) {
    json["mismatch"] = channel.mismatch;
    return json;
  }
  const ValueDifference& d = channel.values;
  json.update({{"values", d.values},
               {"differing", d.differing},
               {"beyond_tolerance", d.beyond_tolerance},
               {"nan_only_a", d.nan_only_a},
               {"nan_only_b", d.nan_only_b},
               {"nan_both", d.nan_both},
               {"infinite", d.infinite},
               {"absolute", spread_json(d.absolute)},
               {"relative", spread_json(d.relative)},
               {"ulps", ulps_json(d.ulps)},
               {"first", pair_json(d.first)},
               {"worst", pair_json(d.worst)}});
  return json;
}

Json channels_json(const PlanesDifference& difference) {
  Json list = Json::array();
  for (const ChannelDifference& channel : difference.channels) {
    list.push_back(channel_json(channel));
  }
  return list;
}

Json head(const Comparison& comparison, Verdict verdict) {
  return {{"format", 1},
          {"program", version_line()},
          {"a", comparison.a},
          {"b", comparison.b},
          {"tolerance",
           {{"absolute", comparison.tolerance.absolute}, {"relative", comparison.tolerance.relative}}},
          {"verdict", name_of(verdict)}};
}

}  // namespace

std::string report_json(const Comparison& comparison, const ImageAnswer& answer) {
  const Selection& selection = answer.measurement.selection;
  Json document = head(comparison, answer.difference.verdict());
  document["passed"] = answer.passed();
  if (!selection.all()) {
    document["selected"] = {{"texels", selection.texels}, {"of", selection.mask.size()}};
  }
  document["channels"] = channels_json(answer.difference);
  for (std::size_t i = 0; i < answer.difference.channels.size(); ++i) {
    if (!answer.difference.channels[i].mismatch.empty()) continue;
    document["channels"][i]["metrics"] = metrics_json(answer.measurement.channels[i]);
  }
  document["looks_like"] = answer.looks_like;
  document["layers"] = layers_json(answer.measurement);
  if (!answer.bounds.empty()) document["bounds"] = bounds_json(answer.bounds);
  return json_text(document);
}

std::string report_json(const Comparison& comparison, const FolderDifference& difference) {
  Json document = head(comparison, difference.verdict());
  document["first_different"] =
      difference.first_different.empty() ? Json(nullptr) : Json(difference.first_different);
  document["attachments"] = Json::array();
  for (const AttachmentDifference& attachment : difference.attachments) {
    Json json = {{"attachment", attachment.name}, {"verdict", name_of(attachment.verdict())}};
    if (attachment.mismatch.empty()) {
      json["channels"] = channels_json(attachment.planes);
      json["looks_like"] = attachment.looks_like;
    } else {
      json["mismatch"] = attachment.mismatch;
    }
    document["attachments"].push_back(json);
  }
  return json_text(document);
}

}  // namespace caustics::app
