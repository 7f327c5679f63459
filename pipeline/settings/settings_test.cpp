#include "pipeline/settings/settings.hpp"

#include <set>

#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/nearest.hpp"
#include "pipeline/settings/setting.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

// The line by which something is refused; "" where it is not.
template <class Action>
std::string refusal_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::WrongUsage);
    return error.what();
  }
  return {};
}

std::string refusal(std::string_view key, std::string_view value) {
  Settings settings;
  return refusal_of([&] { set_option(settings, key, value); });
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A value of a setting that is not its default.
std::string another(const Setting& row) {
  if (row.name == "ground") return "-1.5";
  if (row.name == "sun") return "-30,40.5,2.5";
  if (row.name == "view") return "200,-5";
  if (row.kind == Setting::Kind::Text) return "another";
  if (row.is_number())
    return row.get(Settings{}) == number_text(row.numbers.most) ? number_text(row.numbers.least)
                                                                : number_text(row.numbers.most);
  const auto names = row.choices();
  return std::string(names.front() == row.get(Settings{}) ? names.back() : names.front());
}

}  // namespace

TEST_CASE("settings: every row says all of itself, under a name of its own") {
  std::set<std::string_view> names;
  for (const Setting& row : all_settings()) {
    INFO(row.name);
    CHECK(names.insert(row.name).second);
    CHECK(row.meaning.size() > 8);
    CHECK_FALSE(row.range().empty());
    CHECK_FALSE(row.shown(Settings{}).empty());
  }
  CHECK(names.size() >= 30);
}

TEST_CASE("settings: every default is read back as itself") {
  CHECK_NOTHROW(check_ranges(Settings{}));
  for (const Setting& row : all_settings()) {
    INFO(row.name);
    Settings settings;
    set_option(settings, row.name, another(row));
    set_option(settings, row.name, row.get(Settings{}));
    CHECK(row.get(settings) == row.get(Settings{}));
  }
}

TEST_CASE("settings: what was set is what is got, and nothing else changes") {
  for (const Setting& row : all_settings()) {
    INFO(row.name);
    Settings settings;
    set_option(settings, row.name, another(row));
    CHECK(row.get(settings) == another(row));
    CHECK_NOTHROW(check_ranges(settings));
    for (const Setting& other : all_settings()) {
      if (other.name != row.name) CHECK(other.get(settings) == other.get(Settings{}));
    }
  }
}

TEST_CASE("settings: keys reach the members that they are named after") {
  Settings settings;
  for (const auto& [key, value] :
       std::initializer_list<std::pair<const char*, const char*>>{{"width", "1"},
                                                                  {"grid", "8192"},
                                                                  {"light.samples", "256"},
                                                                  {"emissive.lights", "on"},
                                                                  {"estimator", "paper"},
                                                                  {"splat", "point"},
                                                                  {"splat.sigma", "1.25"},
                                                                  {"interfaces", "2"},
                                                                  {"weights", "paper"},
                                                                  {"views", "shared"},
                                                                  {"exposure", "-1.5"},
                                                                  {"assume_solid", "yes"},
                                                                  {"cascades", "off"},
                                                                  {"camera", "eye"}})
    set_option(settings, key, value);
  CHECK(settings.width == 1);
  CHECK(settings.grid == 8192);
  CHECK(settings.light_samples == 256);
  CHECK(settings.emissive_lights == EmissiveLights::On);
  CHECK(settings.estimator == Estimator::Paper);
  CHECK(settings.splat == Splat::Point);
  CHECK(settings.gaussian_sigma == 1.25f);
  CHECK(settings.interfaces == Interfaces::Two);
  CHECK(settings.weights == Weights::Paper);
  CHECK(settings.shared_views);
  CHECK(settings.exposure == -1.5f);
  CHECK(settings.assume_solid);
  CHECK_FALSE(settings.cascades);
  CHECK(settings.camera == "eye");
  set_option(settings, "exposure", "auto");
  CHECK_FALSE(settings.exposure.has_value());
}

TEST_CASE("settings: where sun and view stand, and the ground's height, are refused where they are no such") {
  for (const char* value :
       {"", "30", "30,", ",30", "30,40,", "30,91", "361,0", "30,40,-1", "30,40,5,6", "30 ,40", "on"})
    CHECK(holds(refusal("sun", value), "AZIMUTH,ELEVATION"));
  for (const char* value : {"", "30", "30,40,5", "nan,0", "0,inf"})
    CHECK(holds(refusal("view", value), "AZIMUTH,ELEVATION"));
  for (const char* value : {"", "yes", "1e10", "nan", "1 m"})
    CHECK(holds(refusal("ground", value), "HEIGHT"));
}

TEST_CASE("settings: what is out of range is refused with the range") {
  for (const Setting& row : all_settings()) {
    if (row.kind == Setting::Kind::Text) continue;
    for (const std::string& value : {std::string(), std::string("nan"), number_text(row.numbers.most + 1.0),
                                     number_text(row.numbers.least - 100.0), std::string("Auto")}) {
      if (row.kind == Setting::Kind::Choice && row.range().find(value) != std::string::npos && !value.empty())
        continue;
      INFO(row.name << "=" << value);
      CHECK(holds(refusal(row.name, value), row.range()));
    }
  }
  for (const char* value : {"", " 7", "7 ", "+7", "7.0", "0x7", "0", "8193", "1e3", "99999999999"}) {
    INFO(value);
    CHECK(holds(refusal("grid", value), "1..8192"));
  }
  for (const char* value : {"inf", "0.05", "4.1", "1,5"})
    CHECK(holds(refusal("splat.sigma", value), "0.1..4 texels"));
  for (const char* value : {"0", "2", "4", "7", "65"})
    CHECK(holds(refusal("wavelengths", value), "1, 3 or 8..64, default 3"));
  CHECK(refusal("weights", "Paper") == "weights cannot be 'Paper': physical|paper, default physical");
  CHECK(holds(refusal("exposure", "41"), "auto or -40..40 EV, default auto"));
}

TEST_CASE("settings: members out of range are named with the range") {
  Settings settings;
  settings.width = 16385;
  CHECK(refusal_of([&] { check_ranges(settings); }) == "width is 16385, must be 1..16384 pixels");
  settings = {};
  settings.glass_roughness = 1.5f;
  CHECK(refusal_of([&] { check_ranges(settings); }) == "glass.roughness is 1.5, must be 0..1");
  settings = {};
  settings.estimator = static_cast<Estimator>(9);
  CHECK(holds(refusal_of([&] { check_ranges(settings); }), "must be paper|secant|newton|impostor"));
}

TEST_CASE("settings: an unknown key names the nearest") {
  CHECK(refusal("gird", "7") == "unknown key 'gird', did you mean 'grid'?");
  CHECK(holds(refusal("mirror.metalic", "1"), "'mirror.metallic'"));
  CHECK_FALSE(holds(refusal("a\nb", "1"), "\n"));
}

TEST_CASE("settings: names of choices are what sets them") {
  for (const Estimator e : {Estimator::Paper, Estimator::Secant, Estimator::Newton, Estimator::Impostor}) {
    Settings settings;
    set_option(settings, "estimator", name_of(e));
    CHECK(settings.estimator == e);
  }
  for (const Interfaces i : {Interfaces::Auto, Interfaces::One, Interfaces::Two}) {
    Settings settings;
    set_option(settings, "interfaces", name_of(i));
    CHECK(settings.interfaces == i);
  }
}

TEST_CASE("the nearest name is the one with the fewest edits") {
  CHECK(nearest_name("reslution", {"grid", "resolution", "map"}) == "resolution");
  CHECK(nearest_name("x", {"ab", "cd"}) == "ab");
  // A letter too many within is one edit, two others are two.
  CHECK(nearest_name("abcdef", {"abcxyf", "abdef"}) == "abdef");
  CHECK(nearest_name("x", {}).empty());
}

TEST_CASE("a name is suggested only when it is near what was typed") {
  // Two letters swapped are one edit; of four letters one may be wrong, of six two.
  CHECK(suggestion("gird", {"grid", "map"}) == ", did you mean 'grid'?");
  CHECK(suggestion("--gird", {"--grid", "--map"}) == ", did you mean '--grid'?");
  CHECK(suggestion("girdle", {"grid", "map"}, "see --help") == "; see --help");
  CHECK(suggestion("shadwo", {"shadow"}) == ", did you mean 'shadow'?");
  CHECK(suggestion("shdaew", {"shadow"}) == ", did you mean 'shadow'?");
  CHECK(suggestion("shudvew", {"shadow"}) == "; known: 'shadow'");
  CHECK(suggestion("x", {"y"}) == ", did you mean 'y'?");
  CHECK(suggestion("xx", {"yy", "z"}) == "; known: 'yy', 'z'");
  CHECK(suggestion("x", {}) == "; there are none");
  CHECK(suggestion("", {"grid"}, "see --help") == "; see --help");
  CHECK(suggestion("zzz", std::vector<std::string>(13, "y")).ends_with("'y', ..."));
}
