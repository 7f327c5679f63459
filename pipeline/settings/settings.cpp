#include "pipeline/settings/settings.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/nearest.hpp"
#include "pipeline/settings/splat_kernel.hpp"
#include "pipeline/scene/cube_atlas.hpp"

namespace caustics {

namespace {

// Named choices: the texts that the command line takes, in the order of the enumerations.
constexpr std::string_view kEstimators[] = {"paper", "secant", "newton", "impostor"};
constexpr std::string_view kThicknesses[] = {"map", "wyman"};
constexpr std::string_view kSplats[] = {"point", "gaussian", "cell"};
constexpr std::string_view kWeights[] = {"physical", "paper"};
constexpr std::string_view kInterfaces[] = {"auto", "1", "2"};
constexpr std::string_view kFrames[] = {"fitted", "shared"};
constexpr std::string_view kCubes[] = {"auto", "on", "off"};
constexpr std::string_view kYesNo[] = {"no", "yes"};
constexpr std::string_view kOffOn[] = {"off", "on"};
constexpr std::string_view kOffAuto[] = {"off", "auto"};

struct Key {
  std::string_view name;
  std::string_view range;
  std::string_view meaning;
  bool (*set)(Settings&, std::string_view value);  // false when the value is out of range
};

// The whole text must be a finite number within the range; nothing is rounded or cut off silently.
template <class T>
bool number(std::string_view text, T least, T most, T& result) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return false;
  if (!(value >= least && value <= most)) return false;
  result = value;
  return true;
}

template <class T, std::size_t N>
bool choice(std::string_view text, const std::string_view (&names)[N], T& result) {
  const auto found = std::find(std::begin(names), std::end(names), text);
  if (found == std::end(names)) return false;
  result = static_cast<T>(found - std::begin(names));
  return true;
}

bool exposure(Settings& s, std::string_view value) {
  float ev = 0.0f;
  if (value == "auto") return s.exposure.reset(), true;
  if (!number(value, -40.0f, 40.0f, ev)) return false;
  s.exposure = ev;
  return true;
}

// 1, 3, or enough samples for a spectrum.
bool wavelengths(Settings& s, std::string_view value) {
  int count = 0;
  if (!number(value, 1, kMaxWavelengths, count)) return false;
  if (count != 1 && count != 3 && count < kLeastSpectrum) return false;
  s.wavelengths = count;
  return true;
}

using Value = std::string_view;

// Every key of -D. The command line's own options are short forms of these.
constexpr Key kKeys[] = {
    {"width", "1..16384 pixels, default 1280", "width of the picture",
     [](Settings& s, Value v) { return number(v, 1, kMaxPicture, s.width); }},
    {"height", "1..16384 pixels, default 720", "height of the picture",
     [](Settings& s, Value v) { return number(v, 1, kMaxPicture, s.height); }},
    {"grid", "1..8192, default 512", "grid vertices a side, each one ray from the light",
     [](Settings& s, Value v) { return number(v, 1, kMaxGrid, s.grid); }},
    {"map", "1..8192 texels, default 512", "side of the caustic map and of the receiver map",
     [](Settings& s, Value v) { return number(v, 1, kMaxMap, s.map); }},
    {"shadow", "1..8192 texels, default 2048", "side of the shadow map",
     [](Settings& s, Value v) { return number(v, 1, kMaxMap, s.shadow); }},
    {"light.samples", "1..256, default 16", "points by which a light with a size is drawn",
     [](Settings& s, Value v) { return number(v, 1, kMaxLightSamples, s.light_samples); }},
    {"emissive.lights", "off|on, default off", "meshes that shine light the scene",
     [](Settings& s, Value v) { return choice(v, kOffOn, s.emissive_lights); }},
    {"shafts", "1..1024, default 128", "beams a side by which light shafts are drawn",
     [](Settings& s, Value v) { return number(v, 1, kMaxShafts, s.shafts); }},
    {"medium.steps", "1..1024, default 32", "steps of each camera ray through a medium",
     [](Settings& s, Value v) { return number(v, 1, kMaxMediumSteps, s.medium_steps); }},
    {"iterations", "1..1000, default 5", "steps of the estimator at each surface",
     [](Settings& s, Value v) { return number(v, 1, kMaxIterations, s.iterations); }},
    {"estimator", "paper|newton|secant|impostor", "what finds where a ray lands, default secant",
     [](Settings& s, Value v) { return choice(v, kEstimators, s.estimator); }},
    {"thickness", "map|wyman, default map", "what tells a ray's way inside a solid caster",
     [](Settings& s, Value v) { return choice(v, kThicknesses, s.thickness); }},
    {"splat", "point|gaussian|cell, default cell", "how a landing becomes light in the map",
     [](Settings& s, Value v) { return choice(v, kSplats, s.splat); }},
    {"splat.sigma", "0.1..4 texels, default 0.7", "width of the gaussian splat",
     [](Settings& s, Value v) { return number(v, 0.1f, 4.0f, s.gaussian_sigma); }},
    {"interfaces", "auto|1|2, default auto", "surfaces that bend light; auto: 2 for closed meshes",
     [](Settings& s, Value v) { return choice(v, kInterfaces, s.interfaces); }},
    {"weights", "physical|paper, default physical", "flux of a ray: physical, or equation 6",
     [](Settings& s, Value v) { return choice(v, kWeights, s.weights); }},
    {"wavelengths", "1, 3 or 8..64, default 3", "samples of the spectrum where glass disperses",
     [](Settings& s, Value v) { return wavelengths(s, v); }},
    {"reflections", "no|yes, default no", "what glass and water mirror throws caustics too",
     [](Settings& s, Value v) { return choice(v, kYesNo, s.reflections); }},
    {"frames", "fitted|shared, default fitted", "shared: the maps keep the caster map's window",
     [](Settings& s, Value v) { return choice(v, kFrames, s.shared_views); }},
    {"cube", "auto|on|off, default auto", "lights among their casters see all around",
     [](Settings& s, Value v) { return choice(v, kCubes, s.cube); }},
    {"cascades", "auto|off, default auto", "a caustic that is small in its map gets a finer one",
     [](Settings& s, Value v) { return choice(v, kOffAuto, s.cascades); }},
    {"pixel_means", "auto|off, default auto", "caustics are averaged over pixels wider than texels",
     [](Settings& s, Value v) { return choice(v, kOffAuto, s.pixel_means); }},
    {"hidden_receivers", "auto|off, default auto", "light lands on what others hide from the light",
     [](Settings& s, Value v) { return choice(v, kOffAuto, s.hidden_receivers); }},
    {"outside_share", "0..0.5, default 0.004", "share of the flux that may fall outside the map",
     [](Settings& s, Value v) { return number(v, 0.0, 0.5, s.outside_share); }},
    {"assume_solid", "no|yes, default no", "glass without a volume is solid instead of thin",
     [](Settings& s, Value v) { return choice(v, kYesNo, s.assume_solid); }},
    {"exposure", "auto or -40..40 EV, default auto", "exposure of the picture",
     [](Settings& s, Value v) { return exposure(s, v); }},
    {"camera", "a name or a number, default the first", "the camera of the picture",
     [](Settings& s, Value v) { return s.camera = v, true; }},
    {"mirror.metallic", "0..1, default 0.5", "at least this metallic is a mirror",
     [](Settings& s, Value v) { return number(v, 0.0f, 1.0f, s.mirror_metallic); }},
    {"mirror.roughness", "0..1, default 0.2", "rougher metal is no mirror",
     [](Settings& s, Value v) { return number(v, 0.0f, 1.0f, s.mirror_roughness); }},
    {"glass.roughness", "0..1, default 0.2", "rougher glass throws no caustic",
     [](Settings& s, Value v) { return number(v, 0.0f, 1.0f, s.glass_roughness); }},
};

// User text inside a one-line message: cut where it is long, control characters replaced.
std::string in_quotes(std::string_view text) {
  std::string result = "'" + std::string(text.substr(0, 60)) + (text.size() > 60 ? "...'" : "'");
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return result;
}

void check_range(std::string_view name, int value, int most) {
  if (value >= 1 && value <= most) return;
  throw Error(ExitCode::WrongUsage, std::string(name) + " is " + std::to_string(value) +
                                        ", must be 1.." + std::to_string(most));
}

std::string too_small(std::string_view name, int side, int guard) {
  const int least = std::max(kLeastAtlas, 9 * guard);
  if (side >= least) return {};
  return std::string(name) + " is " + std::to_string(side) + ", must be at least " + std::to_string(least);
}

}  // namespace

int caustic_guard(const Settings& settings) {
  const int kernel = static_cast<int>(std::ceil(splat_kernel(settings).radius)) + 2;
  return std::max({kLeastGuard, kernel, settings.map / 40});
}

std::string too_small_for_cubes(const Settings& settings) {
  std::string small = too_small("grid", settings.grid, kLeastGuard);
  if (small.empty()) small = too_small("map", settings.map, caustic_guard(settings));
  if (small.empty()) small = too_small("shadow", settings.shadow, kLeastGuard);
  return small;
}

void set_option(Settings& settings, std::string_view key, std::string_view value) {
  const auto found =
      std::find_if(std::begin(kKeys), std::end(kKeys), [&](const Key& k) { return k.name == key; });
  if (found == std::end(kKeys)) {
    std::vector<std::string> names;
    for (const Key& k : kKeys) names.emplace_back(k.name);
    throw Error(ExitCode::WrongUsage, "unknown key " + in_quotes(key) + ", did you mean '" +
                                          nearest_name(key, names) + "'?");
  }
  if (!found->set(settings, value)) {
    throw Error(ExitCode::WrongUsage, std::string(key) + " cannot be " + in_quotes(value) + ": " +
                                          std::string(found->range));
  }
}

std::vector<std::string> setting_keys() {
  std::size_t name_width = 0, range_width = 0;
  for (const Key& key : kKeys) {
    name_width = std::max(name_width, key.name.size());
    range_width = std::max(range_width, key.range.size());
  }
  std::vector<std::string> lines;
  for (const Key& key : kKeys) {
    std::string line(key.name);
    line.resize(name_width + 2, ' ');
    line += key.range;
    line.resize(name_width + 2 + range_width + 2, ' ');
    lines.push_back(line + std::string(key.meaning));
  }
  return lines;
}

void check(const Settings& settings) {
  check_range("width", settings.width, kMaxPicture);
  check_range("height", settings.height, kMaxPicture);
  check_range("grid", settings.grid, kMaxGrid);
  check_range("map", settings.map, kMaxMap);
  check_range("shadow", settings.shadow, kMaxMap);
  if (settings.estimator == Estimator::Impostor && settings.map < kLeastAtlas) {
    throw Error(ExitCode::WrongUsage, "map is " + std::to_string(settings.map) +
                                          ", must be at least " + std::to_string(kLeastAtlas) +
                                          " with the estimator impostor");
  }
  if (const std::string small = too_small_for_cubes(settings); settings.cube == Cube::On && !small.empty())
    throw Error(ExitCode::WrongUsage, small + " for -D cube=on");
  check_range("iterations", settings.iterations, kMaxIterations);
  check_range("light.samples", settings.light_samples, kMaxLightSamples);
  check_range("shafts", settings.shafts, kMaxShafts);
  check_range("medium.steps", settings.medium_steps, kMaxMediumSteps);
}

int vertices_per_beam(const Settings& settings) {
  return (settings.grid + settings.shafts - 1) / settings.shafts;
}

int beams_a_side(const Settings& settings) {
  const int vertices = vertices_per_beam(settings);
  return (settings.grid + vertices - 1) / vertices;
}

std::string_view name_of(Estimator estimator) { return kEstimators[static_cast<int>(estimator)]; }
std::string_view name_of(Thickness thickness) { return kThicknesses[static_cast<int>(thickness)]; }
std::string_view name_of(Splat splat) { return kSplats[static_cast<int>(splat)]; }
std::string_view name_of(Weights weights) { return kWeights[static_cast<int>(weights)]; }
std::string_view name_of(Interfaces interfaces) {
  return kInterfaces[static_cast<int>(interfaces)];
}

}  // namespace caustics
