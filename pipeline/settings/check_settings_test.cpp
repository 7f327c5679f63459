#include "pipeline/settings/check_settings.hpp"

#include "pipeline/gpu/error.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

std::string refusal(const Settings& settings) {
  try {
    check(settings);
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::WrongUsage);
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("check of settings: the defaults hold, one out of range is named") {
  CHECK(refusal({}).empty());
  Settings settings;
  settings.grid = 0;
  CHECK(refusal(settings) == "grid is 0, must be auto or 1..8192");
}

TEST_CASE("check of settings: maps too small for six faces are refused where faces are asked for") {
  Settings settings;
  settings.map = 47;
  CHECK(refusal(settings).empty());
  settings.estimator = Estimator::Impostor;
  CHECK(refusal(settings) == "map is 47, must be at least 48 with the estimator impostor");
  settings.estimator = Estimator::Secant;
  settings.cube = Cube::On;
  CHECK(refusal(settings) == "map is 47, must be at least 48 for -D cube=on");
  settings.map = 64;
  CHECK(refusal(settings).empty());
  settings.gaussian_sigma = 4.0f;  // its kernel reaches 12 texels: a guard of 14
  CHECK(refusal(settings) == "map is 64, must be at least 126 for -D cube=on");
  settings.gaussian_sigma = 0.7f;
  settings.shadow = 16;
  CHECK(refusal(settings) == "shadow is 16, must be at least 48 for -D cube=on");
}
