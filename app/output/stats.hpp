// --stats: what ran, how long it took, and where the light went, as JSON.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/flux.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/settings/setting.hpp"

namespace caustics::app {

// Milliseconds of the steps around the passes.
struct Timing {
  double load = 0.0, prepare = 0.0, passes = 0.0, write = 0.0, total = 0.0;
};

// What --frames showed: the passes' time of each frame, and what the device had made after the first.
struct FrameStats {
  std::vector<double> milliseconds;
  DeviceObjects made_by_first;
};

// Keys and values as -D has them.
nlohmann::ordered_json settings_json(const Settings& settings,
                                     const std::vector<Setting::Part>& parts = all_parts());
// A pass's times and counters.
nlohmann::ordered_json counters_json(const PassReport& report);
// Relative L1 of the caustic, by parts; null where it is not estimated, and of the model where it is not
// judged.
nlohmann::ordered_json error_json(const ErrorEstimate& error);
// Of text for each pass, and a little more.
inline constexpr std::size_t kBytesOfPassInStats = 500;
std::string stats_text(const RenderedFrame& frame, const std::vector<PassReport>& reports,
                       const std::vector<LightLedger>& ledgers, const Timing& timing,
                       const FrameStats& frames);

// A JSON document with a line break at its end. Invalid UTF-8 from file names is replaced; characters that
// one_line would not show as they are stand there as escapes. `indent`: -1 for one line.
std::string json_text(const nlohmann::ordered_json& document, int indent = 2);

}  // namespace caustics::app
