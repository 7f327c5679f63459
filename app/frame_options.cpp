#include "app/frame_options.hpp"

namespace caustics::app {

namespace {

constexpr double kLatest = 1e6;  // seconds

// An option that is the short form of a `-D` key.
struct SettingOption {
  const char* names;
  const char* key;
  const char* value;
  const char* help;
};

constexpr SettingOption kMethod[] = {
    {"--grid", "grid", "N", "grid vertices a side, one ray each; 1..8192 (default 512)"},
    {"--map", "map", "N", "texels a side of the caustic map; 1..8192 (default 512)"},
    {"--iterations", "iterations", "N", "estimator's steps at each surface; 1..1000 (default 5)"},
    {"--estimator", "estimator", "NAME", "where rays land: paper, newton, secant or impostor (default secant)"},
    {"--splat", "splat", "NAME", "point, gaussian or cell: how a ray's light is laid (default cell)"},
    {"--interfaces", "interfaces", "N",
     "1 or 2 surfaces that bend, or auto: 2 for closed meshes (default auto)"},
    {"--wavelengths", "wavelengths", "N",
     "1, 3 or 8..64 samples of the spectrum where glass disperses (default 3)"},
    {"--weights", "weights", "NAME", "physical, or the paper's equation 6 (default physical)"},
};

void add_setting(Parser& parser, Settings& settings, const SettingOption& option) {
  parser.option(option.names, option.value, option.help,
                [&settings, key = option.key](const std::string& value) {
                  set_option(settings, key, value);
                });
}

void assign(Settings& settings, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) {
    throw Error(ExitCode::WrongUsage,
                "-D cannot be '" + assignment.substr(0, 60) + "': key=value, as in splat.sigma=1");
  }
  set_option(settings, assignment.substr(0, equals), assignment.substr(equals + 1));
}

void set_resolution(Settings& settings, const std::string& text) {
  const Pair size = parse_pair("-r", text, 1, kMaxPicture);
  settings.width = size.first;
  settings.height = size.second;
}

}  // namespace

void add_frame_options(Parser& parser, FrameRequest& request, std::vector<Backend>* several) {
  Settings& settings = request.settings;
  parser.group("View");
  parser.option("-r,--resolution", "WxH", "size in pixels; 1..16384 each (default 1280x720)",
                [&](const std::string& value) { set_resolution(settings, value); });
  add_setting(parser, settings,
              {"--camera", "camera", "NAME|N", "the scene's camera (default the first, 0)"});
  add_setting(
      parser, settings,
      {"--exposure", "exposure", "EV", "brightness in EV beside auto's, or auto (default)"});
  parser.option("--environment", "F.hdr", "light from all around: an equirectangular image, nit",
                [&](const std::string& value) { request.environment = value; });
  parser.option("--animation", "NAME|N",
                "the file's animation, or none: the scene at rest (default the first, 0)",
                [&](const std::string& value) { request.animation = value; });
  parser.option("--time", "S", "the moment of the animation in seconds; 0..1e6 (default 0)",
                [&](const std::string& value) {
                  request.seconds = parse_real("--time", value, 0.0, kLatest);
                });
  parser.group("Method");
  for (const SettingOption& option : kMethod) add_setting(parser, settings, option);
  parser.flag("--assume-solid", settings.assume_solid,
              "glass without KHR_materials_volume is solid, not a thin wall");
  parser.repeated("-D", "KEY=VALUE", "any setting, listed below; may stand several times",
                  [&](const std::string& value) { assign(settings, value); });
  parser.group("Running");
  add_backend_options(parser, request.backend, several);
  parser.group("Options");
  std::string footer = "Settings for -D:\n";
  for (const std::string& line : setting_keys()) footer += "  " + line + "\n";
  parser.footer(footer);
}

void check_request(const FrameRequest& request, const std::string& command) {
  if (request.scene.empty()) {
    throw Error(ExitCode::WrongUsage,
                "no scene given; see 'caustics " + command + " --help' for examples");
  }
  check(request.settings);
}

}  // namespace caustics::app
