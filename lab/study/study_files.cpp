// study.json and study.csv.
#include <nlohmann/json.hpp>

#include "lab/study/effect_rows.hpp"
#include "lab/study/study.hpp"

namespace caustics::study {

using Json = nlohmann::ordered_json;

namespace {

constexpr int kFormat = 1;

struct NamedFigure {
  const char* name;
  std::optional<double> Figures::*figure;
};
constexpr NamedFigure kFigures[] = {{"relative_l1", &Figures::relative_l1},
                                    {"rmse", &Figures::rmse},
                                    {"relative_mse_1", &Figures::relative_mse_1},
                                    {"relative_mse_4", &Figures::relative_mse_4},
                                    {"relative_mse_16", &Figures::relative_mse_16},
                                    {"flux_ratio", &Figures::flux_ratio},
                                    {"flip_mean", &Figures::flip_mean}};

Json json_of(const Times& times) {
  return {{"median", times.median}, {"least", times.least}, {"most", times.most}};
}

Times times_from(const Json& json) { return {json.at("median"), json.at("least"), json.at("most")}; }

Json json_of(const Figures& figures) {
  Json json;
  for (const NamedFigure& each : kFigures) {
    const std::optional<double>& value = figures.*each.figure;
    json[each.name] = value ? Json(*value) : Json();
  }
  return json;
}

Figures figures_from(const Json& json) {
  Figures figures;
  for (const NamedFigure& each : kFigures)
    if (!json.at(each.name).is_null()) figures.*each.figure = json.at(each.name).get<double>();
  return figures;
}

Json json_of(const PassTime& pass) {
  return {{"pass", pass.name}, {"runs", pass.runs}, {"caustic", pass.caustic}, {"milliseconds", pass.median}};
}

Json json_of(const std::vector<Knob>& knobs, const StudyRow& row) {
  Json values = Json::object();
  for (std::size_t k = 0; k < knobs.size(); ++k) values[knobs[k].key] = row.point.values[k];
  Json json = {{"values", values},
               {"group", row.point.group},
               {"backend", row.backend},
               {"device", row.device},
               {"repeat", row.repeat},
               {"problem", row.problem},
               {"figures", json_of(row.figures)},
               {"milliseconds", {{"frame", json_of(row.frame)}, {"caustic", json_of(row.caustic)}}},
               {"texture_bytes", row.texture_bytes},
               {"pareto", row.on_front},
               {"reference_limited", row.reference_limited},
               {"picture", row.picture},
               {"settings", row.settings}};
  json["passes"] = Json::array();
  for (const PassTime& pass : row.passes) json["passes"].push_back(json_of(pass));
  return json;
}

StudyRow row_from(const Json& json) {
  StudyRow row;
  row.backend = json.at("backend");
  row.device = json.at("device");
  row.settings = json.at("settings");
  row.repeat = json.at("repeat");
  row.problem = json.at("problem");
  row.figures = figures_from(json.at("figures"));
  row.frame = times_from(json.at("milliseconds").at("frame"));
  row.caustic = times_from(json.at("milliseconds").at("caustic"));
  row.texture_bytes = json.at("texture_bytes");
  row.picture = json.at("picture");
  for (const Json& pass : json.at("passes"))
    row.passes.push_back({pass.at("pass"), pass.at("runs"), pass.at("caustic"), pass.at("milliseconds")});
  return row;
}

// A field of a comma-separated table (RFC 4180).
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string exact(double value) { return Json(value).dump(); }

void add_times(std::string& line, const Times& times) {
  for (const double each : {times.median, times.least, times.most}) line.append(",").append(exact(each));
}

std::string csv_line(const StudyRow& row) {
  std::string line = field(row.point.group) + "," + row.backend;
  for (const std::string& value : row.point.values) line.append(",").append(field(value));
  for (const NamedFigure& each : kFigures) {
    const std::optional<double>& value = row.figures.*each.figure;
    line.append(",").append(value ? exact(*value) : "");
  }
  add_times(line, row.frame);
  add_times(line, row.caustic);
  line.append(",").append(std::to_string(row.texture_bytes));
  line += std::string(",") + (row.on_front ? "1" : "0") + "," + (row.reference_limited ? "1" : "0") + "," +
          field(row.picture) + "," + field(row.problem);
  return line + "\n";
}

}  // namespace

Json study_json(const Study& study) {
  Json document = {{"format", kFormat},
                   {"program", study.program},
                   {"command", study.command},
                   {"identity", study.identity},
                   {"truth", truth_text(study)},
                   {"independent_truth", !study.own_limit},
                   {"truth_noise", study.noise ? Json(*study.noise) : Json()},
                   {"white_lux", study.white},
                   {"planned", study.planned},
                   {"cross", study.cross}};
  document["knobs"] = Json::array();
  for (const Knob& knob : study.knobs)
    document["knobs"].push_back({{"key", knob.key}, {"values", knob.values}, {"base", knob.base}});
  document["rows"] = Json::array();
  for (const StudyRow& row : study.rows) document["rows"].push_back(json_of(study.knobs, row));
  document["drift"] = Json::array();
  for (const Drift& drift : study.drifts)
    document["drift"].push_back(
        {{"backend", drift.backend}, {"before", drift.before}, {"after", drift.after}});
  document["sentences"] = sentences_of(study);
  if (const Json effects = effects_json(study); !effects.empty()) document["effects"] = effects;
  return document;
}

std::string study_csv(const Study& study) {
  std::string text = "group,backend";
  for (const Knob& knob : study.knobs) text += "," + field(knob.key);
  for (const NamedFigure& each : kFigures) text += std::string(",") + each.name;
  for (const char* name : {"frame", "caustic"})
    for (const char* which : {"", "_least", "_most"}) text += std::string(",ms_") + name + which;
  text += ",texture_bytes,pareto,reference_limited,picture,problem\n";
  for (const StudyRow& row : study.rows) text += csv_line(row);
  return text;
}

std::optional<EarlierStudy> read_study(const std::string& text) {
  try {
    const Json document = Json::parse(text);
    if (document.at("format") != kFormat) return std::nullopt;
    EarlierStudy study{document.at("identity"), document.at("white_lux"), {}, {}};
    for (const Json& row : document.at("rows")) study.rows.push_back(row_from(row));
    for (const Json& drift : document.at("drift"))
      study.drifts.push_back({drift.at("backend"), drift.at("before"), drift.at("after")});
    return study;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace caustics::study
