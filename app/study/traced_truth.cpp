#include "app/study/traced_truth.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/command.hpp"
#include "app/progress.hpp"
#include "app/stats.hpp"
#include "app/terminal.hpp"

namespace caustics::app {

namespace {

constexpr double kBetweenReports = 5.0;  // seconds
// What the picture's settings tell the tracer.
constexpr const char* kShared[] = {"emissive.lights", "interfaces", "wavelengths", "reflections", "assume_solid",
                                   "mirror.metallic", "mirror.roughness", "glass.roughness"};

std::string text_of(const nlohmann::ordered_json& value) {
  if (value.is_string()) return value;
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return value.is_number_float() ? significant(value.get<double>(), 9) : value.dump();
}

// As a person would type it, but for how long it runs.
Arguments reference_arguments(const FrameRequest& frame, const TracedTruth& truth, const std::filesystem::path& file) {
  const Settings& settings = frame.settings;
  Arguments arguments{frame.scene.string(),
                      "-o",
                      file.string(),
                      "-r",
                      std::to_string(settings.width) + "x" + std::to_string(settings.height),
                      "--aov",
                      "caustic,caustic_error",
                      "--quiet"};
  const nlohmann::ordered_json json = settings_json(settings);
  for (const char* key : kShared)
    if (json.contains(key)) arguments.insert(arguments.end(), {"-D", std::string(key) + "=" + text_of(json[key])});
  if (!settings.camera.empty()) arguments.insert(arguments.end(), {"--camera", settings.camera});
  if (!frame.animation.empty()) arguments.insert(arguments.end(), {"--animation", frame.animation});
  if (frame.seconds) arguments.insert(arguments.end(), {"--time", significant(*frame.seconds, 9)});
  if (frame.backend.threads > 0) arguments.insert(arguments.end(), {"-t", std::to_string(frame.backend.threads)});
  if (truth.exact) arguments.insert(arguments.end(), {"--exact", "scene"});
  arguments.insert(arguments.end(), {"--error", significant(100.0 * truth.error, 9)});
  return arguments;
}

}  // namespace

void trace_truth(const FrameRequest& frame, const TracedTruth& truth, const std::filesystem::path& file, bool resume,
                 const std::function<void(const std::string&)>& say) {
  const Arguments arguments = reference_arguments(frame, truth, file);
  if (!resume) {
    std::error_code error;
    std::filesystem::remove(file.string() + ".state", error);
  }
  // In pieces, so that it can say how far it is.
  Stopwatch watch;
  bool first = true;
  for (double left = truth.seconds; first || left > 0.0; left = truth.seconds - watch.milliseconds() / 1000.0) {
    say("tracing the truth, " + duration_text(1000.0 * std::max(left, 0.0)) + " at most: ");
    Arguments piece = arguments;
    piece.insert(piece.end(), {"--seconds", significant(std::min(left, kBetweenReports), 6)});
    if (resume || !first) piece.emplace_back("--resume");
    first = false;
    if (run_reference(piece) == ExitCode::Done) return;
  }
}

}  // namespace caustics::app
