#include "app/frame_options.hpp"

#include "app/shell/setting_options.hpp"
#include "app/shell/standard_input.hpp"
#include "pipeline/scene/gltf/load_gltf.hpp"
#include "pipeline/settings/check_settings.hpp"

namespace caustics::app {

void add_moment_options(Parser& parser, FrameRequest& request) {
  constexpr Limits<double> kSeconds{0.0, 1e6};
  parser.option("--animation", "NAME|N",
                {"the file's animation, or none: the scene at rest", "", "the first"},
                [&](const std::string& value) { request.animation = value; });
  parser.number("--time", "S", {"the moment of the animation in seconds", "", "0"}, kSeconds,
                request.seconds);
}

void add_frame_options(Parser& parser, FrameRequest& request, std::vector<Backend>* several,
                       std::vector<int>* thread_counts) {
  SettingOptions options(parser, request.settings, request.given);
  parser.group("View");
  options.add_preview(request.preview);
  options.add_resolution();
  for (const char* name : {"camera", "view", "zoom", "fov", "ground", "sun"}) options.add(name);
  options.add("exposure");
  parser.option("--environment", "F.hdr",
                {"light from all around: an equirectangular image, linear, nit; its centre looks along -z",
                 ".hdr, .exr", "a studio"},
                [&](const std::string& value) { request.environment = value; });
  for (const char* name : {"environment_strength", "environment_turn", "tone_map"}) options.add(name);
  add_moment_options(parser, request);
  parser.group("Method");
  options.add_preset();
  for (const char* name : {"grid", "map", "iterations", "estimator", "splat", "interfaces", "wavelengths",
                           "weights", "assume_solid"})
    options.add(name);
  options.add_any(all_parts());
  parser.group("Running");
  add_backend_options(parser, request.backend, several, thread_counts);
  add_memory_option(parser, request);
}

void add_memory_option(Parser& parser, FrameRequest& request) {
  static constexpr Limits<double> kMegabytes{1.0, 1e9};
  static constexpr double kMegabyte = 1024.0 * 1024.0;
  parser.option("--memory", "MB",
                {"refuse what needs more memory, in MB of 2^20 bytes", text_of(kMegabytes),
                 "three quarters of the machine's, the control group's or ulimit's"},
                [&request](const std::string& value) {
                  request.memory =
                      static_cast<std::uint64_t>(parse_number("--memory", value, kMegabytes) * kMegabyte);
                });
}

std::string name_of_scene(const FrameRequest& request) {
  return is_standard_input(request.scene) ? "stdin" : request.scene.stem().string();
}

void check_request(FrameRequest& request, const std::string& command) {
  if (request.scene.empty()) {
    throw Error(ExitCode::WrongUsage, "no scene given; see 'caustics " + command + " --help' for examples");
  }
  check(request.settings);
  request.files.reads(request.scene, "the scene");
  if (request.environment) request.files.reads(*request.environment, "the image of --environment");
  if (is_standard_input(request.scene)) standard_input(LoadOptions{}.max_bytes);
}

void require_one_sample(const Settings& settings, const std::string& command) {
  if (samples_a_pixel(settings) > 1)
    throw Error(ExitCode::WrongUsage, command + " looks at the pixels' middles, which are no samples of " +
                                          std::to_string(settings.samples) + "; leave out -D samples");
}

}  // namespace caustics::app
