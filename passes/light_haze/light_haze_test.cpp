#include "passes/light_haze/light_haze.hpp"

#include <cmath>

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/hazy_room.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("light_haze: light from above, seen from above, is scattered as the integral over the depth says") {
  // At depth t light has come t through the haze and has t to go: the integral of exp(-2 k t) over 4 m, times
  // 2 lux, times the scattering of 0.1 per metre in all directions alike.
  const Scene scene = hazy_room();
  const View view = down(1.0, 10.0, 20.0);
  LightViews views;
  views.caster = views.shadow = views.panes = view;
  const Effects effects;
  const Settings settings;
  const Pass pass = light_haze_pass();
  const PassImages out =
      run_pass(definition_of(pass), {.uniforms = pass.uniforms({.scene = &scene,
                                                                .settings = &settings,
                                                                .effects = &effects,
                                                                .views = &views,
                                                                .camera = &view,
                                                                .light = &scene.lights[0],
                                                                .width = 1,
                                                                .height = 1}),
                                     .textures = {filled(1, 1, {10.0f, 6.0f, 10.0f, 0.0f}), Image{}, Image{},
                                                  Image{}, Image{}, Image{}, Image{}}});
  const double integral = (1.0 - std::exp(-2.0 * kHaze * kHeight)) / (2.0 * kHaze);
  const double expected = 2.0 * 0.1 / (4.0 * 3.14159265358979) * integral;
  for (int c = 0; c < 3; ++c) CHECK(out["haze"].at(0, 0, c) == Approx(expected).epsilon(1e-5));
}
