#include "app/study_trace.hpp"

#include <algorithm>
#include <fstream>

#include "app/json.hpp"
#include "app/output/stats.hpp"
#include "app/shell/command.hpp"
#include "app/shell/progress.hpp"
#include "app/shell/terminal.hpp"

namespace caustics::app {

namespace {

constexpr double kFirstPiece = 0.25, kLongestPiece = 5.0;  // seconds
// With fewer batches their spread tells little of the error.
constexpr int kLeastBatches = 4;
// What the picture's settings tell the tracer.
constexpr const char* kShared[] = {"emissive.lights",  "interfaces",     "wavelengths",
                                   "reflections",      "assume_solid",   "mirror.metallic",
                                   "mirror.roughness", "glass.roughness"};

std::string text_of(const Json& value) {
  if (value.is_string()) return value;
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return value.is_number_float() ? significant(value.get<double>(), 9) : value.dump();
}

// As a person would type it, but for how long it runs.
Arguments reference_arguments(const FrameRequest& frame, const TracedTruth& truth,
                              const std::filesystem::path& file) {
  const Settings& settings = frame.settings;
  Arguments arguments{frame.scene.string(),
                      "-o",
                      file.string(),
                      "-r",
                      std::to_string(settings.width) + "x" + std::to_string(settings.height),
                      "--aov",
                      "caustic,caustic_error",
                      "--quiet"};
  const Json json = settings_json(settings);
  for (const char* key : kShared)
    if (json.contains(key))
      arguments.insert(arguments.end(), {"-D", std::string(key) + "=" + text_of(json[key])});
  if (!settings.camera.empty()) arguments.insert(arguments.end(), {"--camera", settings.camera});
  if (!frame.animation.empty()) arguments.insert(arguments.end(), {"--animation", frame.animation});
  if (frame.seconds) arguments.insert(arguments.end(), {"--time", significant(*frame.seconds, 9)});
  if (frame.backend.threads > 0)
    arguments.insert(arguments.end(), {"-t", std::to_string(frame.backend.threads)});
  if (truth.exact) arguments.insert(arguments.end(), {"--exact", "scene"});
  arguments.insert(arguments.end(), {"--stats", file.string() + ".json"});
  return arguments;
}

// Runs `reference` for so long, and reads what it says of itself.
TracedLight trace_piece(Arguments arguments, const TracedTruth& truth, const std::filesystem::path& file,
                        double seconds, bool resume) {
  arguments.insert(arguments.end(), {"--seconds", significant(seconds, 6)});
  if (resume) arguments.emplace_back("--resume");
  run_reference(arguments);
  std::ifstream in(file.string() + ".json");
  const Json stats = Json::parse(in);
  TracedLight light{.error = stats.at("noise"), .batches = stats.at("batches"), .notes = stats.at("notes")};
  light.good = light.batches >= kLeastBatches && light.error <= truth.error;
  return light;
}

}  // namespace

TracedLight trace_truth(const FrameRequest& frame, const TracedTruth& truth,
                        const std::filesystem::path& file, TraceFrom from,
                        const std::function<void(const std::string&)>& say,
                        const std::function<void(const std::string&)>& note) {
  const Arguments arguments = reference_arguments(frame, truth, file);
  TracedLight light;
  say("the truth: ");
  if (from != TraceFrom::Nothing && std::filesystem::is_regular_file(file.string() + ".state")) {
    try {
      light = trace_piece(arguments, truth, file, 0.0, true);
      if (from == TraceFrom::Finished || light.good) return light;
    } catch (const Error& error) {
      if (error.code() != ExitCode::BadInput) throw;
      note("the truth is traced anew: " + std::string(error.what()));
      light = {};
    }
  }
  // In pieces, so that it can say how far it is.
  Stopwatch watch;
  double piece = kFirstPiece;
  for (double left = truth.seconds; light.batches == 0 || (left > 0.0 && !light.good);
       left = truth.seconds - watch.milliseconds() / 1000.0) {
    say("tracing the truth, error " + (light.batches ? percent(light.error) : "unknown") + ", " +
        duration_text(1000.0 * std::max(left, 0.0)) + " at most: ");
    light = trace_piece(arguments, truth, file, std::clamp(left, 0.0, piece), light.batches > 0);
    piece = std::min(2.0 * piece, kLongestPiece);
  }
  return light;
}

}  // namespace caustics::app
