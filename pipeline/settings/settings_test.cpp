#include "pipeline/settings/settings.hpp"

#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/nearest.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

std::string refusal(const char* key, const char* value) {
  Settings settings;
  try {
    set_option(settings, key, value);
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::WrongUsage);
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("settings are set by key") {
  Settings settings;
  set_option(settings, "grid", "8192");
  set_option(settings, "estimator", "paper");
  set_option(settings, "splat", "point");
  set_option(settings, "splat.sigma", "1.25");
  set_option(settings, "interfaces", "2");
  set_option(settings, "weights", "paper");
  set_option(settings, "frames", "shared");
  set_option(settings, "exposure", "-1.5");
  set_option(settings, "assume_solid", "yes");
  CHECK(settings.grid == 8192);
  CHECK(settings.estimator == Estimator::Paper);
  CHECK(settings.splat == Splat::Point);
  CHECK(settings.gaussian_sigma == 1.25f);
  CHECK(settings.interfaces == Interfaces::Two);
  CHECK(settings.weights == Weights::Paper);
  CHECK(settings.shared_frames);
  CHECK(settings.exposure == -1.5f);
  CHECK(settings.assume_solid);
  set_option(settings, "light.samples", "256");
  set_option(settings, "emissive.lights", "on");
  CHECK(settings.light_samples == 256);
  CHECK(settings.emissive_lights);
  set_option(settings, "exposure", "auto");
  CHECK_FALSE(settings.exposure.has_value());
}

TEST_CASE("a value is taken as a whole or not at all") {
  for (const char* value :
       {"", " 7", "7 ", "+7", "7.0", "0x7", "0", "8193", "1e3", "99999999999"}) {
    INFO(value);
    CHECK(refusal("grid", value).find("1..8192") != std::string::npos);
  }
  for (const char* value : {"", "nan", "inf", "0.05", "4.1", "1,5"}) {
    INFO(value);
    CHECK(refusal("splat.sigma", value).find("0.1..4 texels") != std::string::npos);
  }
  CHECK(refusal("weights", "Paper") ==
        "weights cannot be 'Paper': physical|paper, default physical");
}

TEST_CASE("an unknown key names the nearest") {
  CHECK(refusal("girdd", "7") == "unknown key 'girdd', did you mean 'grid'?");
  CHECK(refusal("mirror.metalic", "1").find("'mirror.metallic'") != std::string::npos);
  CHECK(refusal("a\nb", "1").find('\n') == std::string::npos);
}

TEST_CASE("names of choices are what sets them") {
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

TEST_CASE("the documented defaults are within the documented ranges") {
  CHECK_NOTHROW(check(Settings{}));
  Settings settings;
  settings.width = kMaxPicture + 1;
  CHECK_THROWS_AS(check(settings), Error);
  CHECK(setting_keys().size() >= 21);
}

TEST_CASE("the nearest name is the one with the fewest edits") {
  CHECK(nearest_name("reslution", {"grid", "resolution", "map"}) == "resolution");
  CHECK(nearest_name("x", {"ab", "cd"}) == "ab");
  CHECK(nearest_name("x", {}).empty());
}
