#include "pipeline/settings/presets.hpp"

#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/check_settings.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("presets: each sets values that hold together, and later ones override it") {
  for (const Preset& preset : all_presets()) {
    Settings settings;
    apply_preset(settings, preset.name);
    CHECK_NOTHROW(check(settings));
  }
  Settings settings;
  apply_preset(settings, "paper");
  CHECK(settings.grid == 128);
  CHECK(settings.iterations == 3);
  CHECK(settings.estimator == Estimator::Paper);
  CHECK(settings.draw_unconverged);
  set_option(settings, "grid", "64");
  CHECK(settings.grid == 64);
}

TEST_CASE("presets: an unknown one is refused, and the known are named") {
  Settings settings;
  CHECK_THROWS_WITH(apply_preset(settings, "shah"), "there is no preset 'shah'; there is 'paper'");
}

TEST_CASE("presets: the preview's values hold together and follow no light any further") {
  Settings settings;
  apply(settings, preview());
  CHECK_NOTHROW(check(settings));
  CHECK(settings.width == 640);
  CHECK(settings.height == 360);
  CHECK(settings.samples == 1);
  CHECK(settings.further_share == 1.0f);
}
