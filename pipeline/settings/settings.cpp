#include "pipeline/settings/settings.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "pipeline/settings/setting.hpp"

namespace caustics {

namespace {

using Part = Setting::Part;
using Range = Setting::Range;
using S = Settings;

// A value and what the command line calls it.
template <class T>
struct Named {
  std::string_view name;
  T value;
};

constexpr Named<Estimator> kEstimators[] = {{"paper", Estimator::Paper},
                                            {"secant", Estimator::Secant},
                                            {"newton", Estimator::Newton},
                                            {"impostor", Estimator::Impostor}};
constexpr Named<Thickness> kThicknesses[] = {{"map", Thickness::Map}, {"wyman", Thickness::Wyman}};
constexpr Named<Splat> kSplats[] = {
    {"point", Splat::Point}, {"gaussian", Splat::Gaussian}, {"cell", Splat::Cell}};
constexpr Named<Weights> kWeights[] = {{"physical", Weights::Physical}, {"paper", Weights::Paper}};
constexpr Named<Interfaces> kInterfaces[] = {
    {"auto", Interfaces::Auto}, {"1", Interfaces::One}, {"2", Interfaces::Two}};
constexpr Named<int> kSamples[] = {{"auto", 0}, {"1", 1}, {"4", 4}, {"8", 8}, {"16", 16}};
constexpr Named<ToneMap> kToneMaps[] = {
    {"film", ToneMap::Film}, {"neutral", ToneMap::Neutral}, {"linear", ToneMap::Linear}};
constexpr Named<bool> kViews[] = {{"fitted", false}, {"shared", true}};
constexpr Named<EmissiveLights> kEmissiveLights[] = {
    {"auto", EmissiveLights::Auto}, {"on", EmissiveLights::On}, {"off", EmissiveLights::Off}};
constexpr Named<Cube> kCubes[] = {{"auto", Cube::Auto}, {"on", Cube::On}, {"off", Cube::Off}};
constexpr Named<bool> kNoYes[] = {{"no", false}, {"yes", true}};
constexpr Named<bool> kOffOn[] = {{"off", false}, {"on", true}};
constexpr Named<bool> kDropDraw[] = {{"drop", false}, {"draw", true}};
constexpr Named<bool> kAutoOff[] = {{"auto", true}, {"off", false}};

// Empty where the value has no name.
template <class T, std::size_t N>
std::string_view name_in(const Named<T> (&named)[N], T value) {
  for (const Named<T>& each : named)
    if (each.value == value) return each.name;
  return {};
}

template <const auto& named>
std::vector<std::string_view> names_of() {
  std::vector<std::string_view> names;
  for (const auto& each : named) names.push_back(each.name);
  return names;
}

template <auto member, const auto& named>
std::string get_choice(const Settings& settings) {
  return std::string(name_in(named, settings.*member));
}

template <auto member, const auto& named>
bool set_choice(const Setting&, Settings& settings, std::string_view text) {
  for (const auto& each : named)
    if (each.name == text) return settings.*member = each.value, true;
  return false;
}

template <auto member>
std::string get_number(const Settings& settings) {
  return number_text(settings.*member);
}

template <auto member>
bool set_number(const Setting& row, Settings& settings, std::string_view text) {
  return read_number(row.numbers, text, settings.*member);
}

template <auto member>
std::string get_text(const Settings& settings) {
  return settings.*member;
}

template <auto member>
bool set_text(const Setting&, Settings& settings, std::string_view text) {
  return settings.*member = text, true;
}

constexpr std::string_view kNone = "auto";  // of a number that is found by itself

template <auto member>
std::string get_optional(const Settings& settings) {
  return settings.*member ? number_text(*(settings.*member)) : std::string(kNone);
}

template <auto member>
bool set_optional(const Setting& row, Settings& settings, std::string_view text) {
  if (text == kNone) return (settings.*member).reset(), true;
  typename std::remove_reference_t<decltype(settings.*member)>::value_type value{};
  if (!read_number(row.numbers, text, value)) return false;
  settings.*member = value;
  return true;
}

template <auto member>
constexpr Setting number(std::string_view name, Part part, Range range, std::string_view meaning) {
  const auto kind = std::is_same_v<decltype(member), int S::*> ? Setting::Kind::Count : Setting::Kind::Real;
  Setting row{name, kind, part, meaning, get_number<member>, set_number<member>};
  row.numbers = range;
  return row;
}

template <auto member>
constexpr Setting optional_number(std::string_view name, Part part, Range range, std::string_view meaning) {
  Setting row{name, Setting::Kind::Real, part, meaning, get_optional<member>, set_optional<member>};
  row.numbers = range;
  row.unset = kNone;
  return row;
}

template <auto member>
std::string get_side(const Settings& settings) {
  const Side& side = settings.*member;
  return side.automatic ? std::string(kNone) : number_text(side.count);
}

template <auto member>
bool set_side(const Setting& row, Settings& settings, std::string_view text) {
  if (text == kNone) return settings.*member = Side{}, true;
  int count = 0;
  if (!read_number(row.numbers, text, count)) return false;
  return settings.*member = count, true;
}

template <auto member>
constexpr Setting side(std::string_view name, Part part, Range range, std::string_view meaning) {
  Setting row{name, Setting::Kind::Count, part, meaning, get_side<member>, set_side<member>};
  row.numbers = range;
  row.unset = kNone;
  return row;
}

template <auto member, const auto& named>
constexpr Setting choice(std::string_view name, Part part, std::string_view meaning) {
  const bool yes_no = static_cast<const void*>(&named) == static_cast<const void*>(&kNoYes);
  const auto kind = yes_no ? Setting::Kind::YesNo : Setting::Kind::Choice;
  Setting row{name, kind, part, meaning, get_choice<member, named>, set_choice<member, named>};
  row.choices = names_of<named>;
  return row;
}

template <auto member>
constexpr Setting text(std::string_view name, Part part, std::string_view takes, std::string_view unset,
                       std::string_view meaning) {
  Setting row{name, Setting::Kind::Text, part, meaning, get_text<member>, set_text<member>};
  row.takes = takes;
  row.unset = unset;
  return row;
}

// What text_of and parse (stage.hpp) write and read.
template <auto member>
std::string get_staged(const Settings& settings) {
  return text_of(settings.*member);
}

template <auto member>
bool set_staged(const Setting&, Settings& settings, std::string_view text) {
  return parse(text, settings.*member);
}

template <auto member>
constexpr Setting staged(std::string_view name, Part part, std::string_view takes, std::string_view meaning) {
  Setting row{name, Setting::Kind::Text, part, meaning, get_staged<member>, set_staged<member>};
  row.takes = takes;
  return row;
}

constexpr Setting kTable[] = {
    number<&S::width>("width", Part::View, {1, 16384, "pixels"}, "width of the picture"),
    number<&S::height>("height", Part::View, {1, 16384, "pixels"}, "height of the picture"),
    side<&S::grid>(
        "grid", Part::Maps, {1, 8192},
        "grid vertices a side: rays from the light; auto: 512 to 704, with the map; 256 or 384 with "
        "rough glass"),
    side<&S::map>("map", Part::Maps, {1, 8192, "texels"},
                  "side of caustic and receiver map; auto: 512 to 1280, as the picture shows sharp edges"),
    number<&S::shadow>("shadow", Part::Maps, {1, 8192, "texels"}, "side of the shadow map"),
    number<&S::light_samples>("light.samples", Part::Maps, {1, 256},
                              "points by which a light with a size is drawn"),
    number<&S::least_light>("light.least", Part::Maps, {0, 1},
                            "of more than 16 lights, the weakest that together give less than this share of "
                            "the light on any caster throw no caustic"),
    number<&S::full_light>("light.full", Part::Maps, {0, 1},
                           "of more than 16 lights, those that give less than this share of the light on any "
                           "caster have smaller grids and maps"),
    number<&S::most_lights>("light.most", Part::Maps, {0, 65536},
                            "of more lights, so many throw caustics, each for those near it as well; 0: all"),
    choice<&S::emissive_lights, kEmissiveLights>(
        "emissive.lights", Part::Light,
        "meshes that shine light the scene; auto: those that add enough to the other light"),
    number<&S::shafts>("shafts", Part::Maps, {1, 1024},
                       "beams a side by which light shafts are drawn; no more than the grid has vertices"),
    number<&S::medium_steps>("medium.steps", Part::Maps, {1, 1024},
                             "steps of each camera ray through a medium"),
    number<&S::iterations>("iterations", Part::Maps, {1, 1000}, "steps of the estimator at each surface"),
    choice<&S::estimator, kEstimators>("estimator", Part::Maps, "what finds where a ray lands"),
    optional_number<&S::search_start>(
        "search.start", Part::Maps, {0, 1e6, "metres"},
        "where on the ray the estimators paper and newton begin; auto: 0 and 0.10"),
    optional_number<&S::newton_epsilon>(
        "newton.epsilon", Part::Maps, {1e-6, 1e3, "metres"},
        "step of the estimator newton's forward difference; auto: a texel's extent"),
    choice<&S::newton_guard, kOffOn>("newton.guard", Part::Maps,
                                     "the estimator newton takes no step where its slope is lost, nor beyond "
                                     "the light's view"),
    choice<&S::draw_unconverged, kDropDraw>(
        "unconverged", Part::Maps,
        "light whose search has not ended on a surface: booked as lost, or drawn where the search stopped"),
    choice<&S::thickness, kThicknesses>(
        "thickness", Part::Maps,
        "what tells a ray's way inside a solid caster: the map of its back, or "
        "Wyman's (2005) mean of two thicknesses"),
    choice<&S::splat, kSplats>("splat", Part::Maps,
                               "how landings become light in the map: one by one, or as cells of four"),
    number<&S::gaussian_sigma>("splat.sigma", Part::Maps, {0.1, 4.0, "texels"},
                               "standard deviation of the Gaussian, and of what cells leave to splats"),
    choice<&S::interfaces, kInterfaces>(
        "interfaces", Part::Light,
        "surfaces that bend light; auto: 2 where the mesh encloses a volume, else 1"),
    choice<&S::weights, kWeights>("weights", Part::Maps,
                                  "flux of a ray: physical, or the paper's equation 6"),
    number<&S::wavelengths>(
        "wavelengths", Part::Light, {.least = 8, .most = 64, .also = {1, 3}},
        "samples of the spectrum where glass disperses (KHR_materials_dispersion): 1 bends "
        "all colours alike, 3 are red, green and blue at the C, d and F lines, 8 and more "
        "have the colours of the CIE 1931 observer"),
    choice<&S::reflections, kNoYes>("reflections", Part::Light,
                                    "light that glass and water mirror throws caustics too"),
    number<&S::further_share>("further.share", Part::Light, {0, 1},
                              "light is followed from surface to surface where at least this share of what "
                              "lands goes other ways than through two; 1: nothing is followed, nor are the "
                              "camera's rays"),
    number<&S::bounces>("bounces", Part::Maps, {2, 64}, "surfaces that light is followed through at most"),
    number<&S::splits>("splits", Part::Maps, {0, 4},
                       "surfaces at which light is followed both ways, mirrored and let through"),
    choice<&S::drawn, kAutoOff>("drawn", Part::Maps,
                                "light that goes other ways is followed by ways that are drawn, with grain"),
    number<&S::least_share>("least_share", Part::Maps, {0, 0.5},
                            "share of a ray's light below which it is followed no further"),
    choice<&S::shared_views, kViews>("views", Part::Maps,
                                     "the light's views: fitted to each map, or all that of the caster map"),
    choice<&S::cube, kCubes>("cube", Part::Maps,
                             "which lights see all around, by a cube's six faces: those among their casters, "
                             "all that have a position, or none"),
    choice<&S::cascades, kAutoOff>("cascades", Part::Maps,
                                   "a finer second map for a caustic that is small in its map"),
    choice<&S::pixel_means, kAutoOff>(
        "pixel_means", Part::Maps,
        "the mean of a caustic over each pixel that is wider than the map's texels"),
    choice<&S::hidden_receivers, kAutoOff>("hidden_receivers", Part::Maps,
                                           "caustics on receivers that other receivers hide from the light"),
    number<&S::outside_share>("outside_share", Part::Maps, {0.0, 0.5},
                              "share of the landed flux that may fall outside the fitted caustic map"),
    choice<&S::assume_solid, kNoYes>("assume_solid", Part::Light,
                                     "glass without KHR_materials_volume is solid instead of a thin wall"),
    optional_number<&S::exposure>("exposure", Part::Picture, {-40, 40, "EV"},
                                  "brightness of PNG pictures beside the automatic one"),
    choice<&S::samples, kSamples>(
        "samples", Part::Picture,
        "of a pixel, whose mean is shown; auto: 4 where pictures are only looked at"),
    choice<&S::highlights, kAutoOff>("highlights", Part::Picture,
                                     "mirror images of lights, and in receivers of the environment"),
    choice<&S::ambient_occlusion, kAutoOff>("ambient.occlusion", Part::Picture,
                                            "surfaces keep the environment's light from others near by"),
    choice<&S::tone_map, kToneMaps>(
        "tone_map", Part::Picture,
        "PNG pictures: with as much contrast as brings what glows to white, as neutral (Khronos PBR Neutral: "
        "bright light is pressed), or cut off at white"),
    number<&S::environment_strength>("environment_strength", Part::Picture, {0, 1e6},
                                     "factor on the light from all around"),
    number<&S::environment_turn>("environment_turn", Part::Picture, {-360, 360, "degrees"},
                                 "turned about the vertical, anticlockwise from above"),
    text<&S::camera>("camera", Part::View, "a name or a number", "the first", "a camera of the scene"),
    staged<&S::view>(
        "view", Part::View, "auto|AZIMUTH,ELEVATION: -360..360, -90..90",
        "shows the scene and its caustics whole, from there instead of the scene's camera: degrees "
        "from +z towards +x, and above the horizon; auto: 37,34 where there is no camera"),
    number<&S::zoom>("zoom", Part::View, {0.01, 100}, "how much larger the camera shows what it looks at"),
    optional_number<&S::fov>("fov", Part::View, {1, 170, "degrees"},
                             "the camera's vertical angle of view; auto: its own, else 34, wider inside a "
                             "room"),
    staged<&S::ground>(
        "ground", Part::Light, "auto|on|off|HEIGHT",
        "a grey ground below the scene, or at this height, metres; auto: where no floor reaches well "
        "beyond what is shown, or the scene itself catches less than half of its caustics"),
    staged<&S::sun>("sun", Part::Light, "auto|AZIMUTH,ELEVATION[,LUX]: -360..360, -90..90, 0..1e9",
                    "a sun that stands there, in place of the scene's lights: degrees as for view; lux "
                    "unless said 10, or 3.3 times the environment's; auto: where there is no light"),
    number<&S::mirror_metallic>("mirror.metallic", Part::Light, {0, 1},
                                "metal is a mirror where it is at least so metallic"),
    number<&S::mirror_roughness>("mirror.roughness", Part::Light, {0, 1}, "rougher metal is no mirror"),
    number<&S::glass_roughness>("glass.roughness", Part::Light, {0, 1},
                                "rougher glass spreads light and view"),
};

}  // namespace

std::span<const Setting> all_settings() { return kTable; }

int vertices_per_beam(const Settings& settings) {
  return (settings.grid + settings.shafts - 1) / settings.shafts;
}

int beams_a_side(const Settings& settings) {
  const int vertices = vertices_per_beam(settings);
  return (settings.grid + vertices - 1) / vertices;
}

std::string_view name_of(Estimator estimator) { return name_in(kEstimators, estimator); }
std::string_view name_of(Thickness thickness) { return name_in(kThicknesses, thickness); }
std::string_view name_of(Splat splat) { return name_in(kSplats, splat); }
std::string_view name_of(Interfaces interfaces) { return name_in(kInterfaces, interfaces); }

}  // namespace caustics
