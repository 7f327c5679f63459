// One file under the program's own limits: loaded, completed, and rendered small with the defaults and with
// everything else that may be asked for. Prints "loaded", "refused: why" or "rendered"; anything that it does
// not survive is a finding.
#include <cstdio>

#include "tests/fuzz/fuzzed_scene.hpp"

namespace {

using namespace caustics;

constexpr int kSide = 48;

Settings plain() {
  Settings settings;
  settings.width = settings.height = settings.grid = settings.map = settings.shadow = kSide;
  settings.light_samples = 2;
  return settings;
}

Settings rich() {
  Settings settings = plain();
  settings.estimator = Estimator::Impostor;
  settings.splat = Splat::Gaussian;
  settings.wavelengths = 8;
  settings.reflections = settings.assume_solid = true;
  settings.emissive_lights = EmissiveLights::On;
  return settings;
}

}  // namespace

int main(int count, char** arguments) {
  using namespace caustics::fuzz;
  if (count != 2) {
    std::fprintf(stderr, "usage: fuzz_try FILE\n");
    return 2;
  }
  std::string why;
  const auto animated = load_path(arguments[1], LoadOptions{}, &why);
  if (!animated) {
    std::printf("refused: %s\n", why.c_str());
    return 0;
  }
  check_sound(animated->start());
  const double seconds = 0.37 * animated->duration();
  const auto scene = scene_at(*animated, seconds);
  bool rendered = scene.has_value();
  for (const Settings& settings : {plain(), rich()})
    rendered = rendered && render_frame(*scene, settings, seconds);
  std::printf(rendered ? "rendered\n" : "loaded\n");
  return 0;
}
