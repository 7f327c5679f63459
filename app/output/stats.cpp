#include "app/output/stats.hpp"

#include <algorithm>
#include <string>

#include "app/json.hpp"
#include "app/output/light_groups.hpp"
#include "app/shell/version.hpp"
#include "lab/study/times.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::app {

namespace {

Json objects_json(const DeviceObjects& objects) {
  return {{"programs", objects.programs},         {"buffers", objects.buffers},
          {"textures", objects.textures},         {"vertex_layouts", objects.vertex_layouts},
          {"framebuffers", objects.framebuffers}, {"read_backs", objects.read_backs}};
}

// A steady loop makes nothing after its first frame, and reads back what it writes to files alone.
Json frames_json(const FrameStats& frames, const DeviceObjects& made) {
  return {{"count", frames.milliseconds.size()},
          {"milliseconds", frames.milliseconds},
          {"median", study::times_of(frames.milliseconds).median},
          {"made_by_first", objects_json(frames.made_by_first)},
          {"made_by_all", objects_json(made)}};
}

Json ledger_json(const Scene& scene, const LightLedger& entry) {
  const Light& light = scene.sources[static_cast<std::size_t>(entry.light)];
  Json flux = {{"unit", flux_unit(light)}};
  for (const auto& [name, value] : accounts(entry.ledger)) flux[name] = value;
  flux["rounding"] = entry.ledger.rounding;
  flux["rounding_bound"] = entry.ledger.rounding_bound;
  flux["residual"] = entry.ledger.residual();
  Json vertices;
  for (int s = 0; s < kLandingStatuses; ++s) {
    vertices[std::string(name_of(static_cast<LandingStatus>(s)))] =
        entry.ledger.vertices[static_cast<std::size_t>(s)];
  }
  return {{"light", entry.light},
          {"name", light.name},
          {"intensity", light.intensity},
          {"intensity_unit", intensity_unit(light)},
          {"samples", samples_of(scene, entry.light).size()},
          {"flux", flux},
          {"leaves_share", entry.leaves()},
          {"estimated_error", error_json(entry.error)},
          {"vertices", vertices}};
}

}  // namespace

Json counters_json(const PassReport& report) {
  return {{"pass", report.label},
          {"milliseconds", report.result.milliseconds},
          {"processor_milliseconds", report.result.processor_milliseconds},
          {"vertices", report.result.vertices},
          {"primitives", report.result.primitives},
          {"fragments", report.result.fragments},
          {"samples_passed", report.result.samples_passed},
          {"operations", report.result.operations},
          {"left_out", report.result.left_out}};
}

Json error_json(const ErrorEstimate& error) {
  if (!(error.landed > 0.0)) return nullptr;
  const auto judged = [&](double value) { return error.judged ? Json(error.relative(value)) : Json(); };
  return {{"total", error.total()},
          {"map", error.relative(error.map)},
          {"grid", error.relative(error.grid)},
          {"missing", error.relative(error.missing)},
          {"model", judged(error.model)},
          {"sampling", judged(error.sampling)},
          {"not_followed", judged(error.not_followed)}};
}

Json settings_json(const Settings& settings, const std::vector<Setting::Part>& parts) {
  Json json = Json::object();
  for (const Setting& row : all_settings()) {
    if (std::find(parts.begin(), parts.end(), row.part) == parts.end()) continue;
    const std::string value = row.get(settings);
    // As numbers where they are; "auto" is none.
    const bool text = !row.is_number() || value == row.unset;
    json[std::string(row.name)] = text                               ? Json(value)
                                  : row.kind == Setting::Kind::Count ? Json(std::stoi(value))
                                                                     : Json(std::stod(value));
  }
  return json;
}

namespace {

// Puts the passes where the document has none. There may be a hundred thousand of them, and as a document of
// its own each takes three times the memory of its text.
std::string with_passes(const std::string& document, const std::vector<PassReport>& reports) {
  constexpr std::string_view kNone = "\n  \"passes\": [";
  const std::size_t at = document.find(kNone) + kNone.size();
  std::string text = document.substr(0, at);
  text.reserve(document.size() + reports.size() * kBytesOfPassInStats);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    std::string pass = json_text(counters_json(reports[i]));
    pass.pop_back();  // the line break
    text += i == 0 ? "\n    " : ",\n    ";
    for (const char c : pass) text += c == '\n' ? "\n    " : std::string(1, c);
  }
  if (!reports.empty()) text += "\n  ";
  return text.append(document, at);
}

}  // namespace

std::string stats_text(const RenderedFrame& frame, const std::vector<PassReport>& reports,
                       const std::vector<LightLedger>& ledgers, const Timing& timing,
                       const FrameStats& frames) {
  Json document = {{"format", 1},
                   {"program", version_line()},
                   {"scene", frame.scene().file},
                   {"device", frame.device().description()},
                   {"settings", settings_json(frame.settings())},
                   {"milliseconds",
                    {{"load", timing.load},
                     {"prepare", timing.prepare},
                     {"passes", timing.passes},
                     {"write", timing.write},
                     {"total", timing.total}}},
                   {"texture_bytes", frame.plan().bytes()},
                   {"memory_bytes", {{"stated", frame.memory().needed}, {"peak", resident_memory().peak}}},
                   {"frames", frames_json(frames, frame.device().made())}};
  document["passes"] = Json::array();
  document["lights"] = Json::array();
  for (const LightLedger& ledger : ledgers) {
    document["lights"].push_back(ledger_json(frame.scene(), ledger));
  }
  document["notes"] = frame.scene().notes;
  return with_passes(json_text(document), reports);
}

// Characters that one_line would not show as they are can stand in strings alone, where JSON has escapes of
// its own.
std::string json_text(const Json& document, int indent) {
  const std::string text = document.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<unsigned char>(text[at]);
    if (byte < 0x7F) {
      result += text[at++];
      continue;
    }
    const std::size_t bytes = byte < 0x80 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;  // of UTF-8
    const std::string character = text.substr(at, bytes);
    at += bytes;
    if (one_line(character) == character) {
      result += character;
    } else {
      const std::string quoted = Json(character).dump(-1, ' ', true);
      result += quoted.substr(1, quoted.size() - 2);
    }
  }
  return result;
}

}  // namespace caustics::app
