#include "pipeline/renderer/picture_sides.hpp"
#include "pipeline/effects/branches.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

View window() {
  View view;
  view.forward = {0.0, 0.0, 1.0};
  view.near = -1.0;
  view.far = 1.0;
  return view;
}

Scene lit_by(int samples) {
  Scene scene;
  Light light;
  light.source = 0;
  scene.lights.assign(static_cast<std::size_t>(samples), light);
  return scene;
}

// A fold that holds `share` of the light in cells as wide as a pixel of the map's own size.
Settings chosen(double share, int samples = 1, const std::vector<Window>& cells = {},
                bool is_followed = false) {
  Settings settings;
  settings.width = 512;
  LightViews views;
  views.caustic = window();
  const LandingSurvey survey{.grid = 96,
                             .branches = 1,
                             .edges = {{.at = {}, .flux = share, .width = 2.0 / 512, .fold = true}},
                             .cells = cells,
                             .flux = 1.0};
  const auto count = static_cast<std::size_t>(samples);
  return with_sides_for_picture(settings, lit_by(samples), is_followed,
                                std::vector<LandingSurvey>(count, survey),
                                std::vector<LightViews>(count, views), window());
}

}  // namespace

TEST_CASE("picture sides: a caustic without sharp edges keeps the least") {
  CHECK(chosen(0.0).map == 512);
  CHECK(chosen(0.0).grid == 512);
}

// Of a fold's light 0.28 is blurred at one texel a pixel, and by the power 5/4 less with more.
TEST_CASE("picture sides: the least map that blurs no more than 0.4 % is chosen") {
  CHECK(chosen(0.014).map == 512);  // 0.392 %
  CHECK(chosen(0.015).map == 768);  // 0.42 % at 512, 0.25 % at 768
  CHECK(chosen(0.03).map == 1024);  // 0.51 % at 768, 0.35 % at 1024
  CHECK(chosen(0.04).map == 1280);  // 0.47 % at 1024
  CHECK(chosen(1.0).map == 1280);   // not enough, and as much as there is
  CHECK(chosen(1.0).grid == 704);
}

TEST_CASE("picture sides: of light that is followed the grid grows when cascades need it to") {
  const auto followed = [](double share) { return chosen(share, 1, {}, true); };
  CHECK(followed(0.03).map == 1024);
  CHECK(followed(0.03).grid == 512);
  CHECK(followed(1.0).map == 1280);
  CHECK(followed(1.0).grid == 640);
}

TEST_CASE("picture sides: where every caster is rough glass all light is spread") {
  Effects effects;
  effects.surfaces = {{.role = Role::Receiver, .reason = ""},
                      {.role = Role::Refractor, .reason = "", .rough = true}};
  effects.rough_glass.active = true;
  CHECK_FALSE(all_light_is_spread(effects));  // as long as light is not followed
  effects.further_surfaces.active = true;
  CHECK(all_light_is_spread(effects));
  effects.surfaces.push_back({.role = Role::Mirror, .reason = ""});
  CHECK_FALSE(all_light_is_spread(effects));
}

TEST_CASE("picture sides: edges of lights with a size are soft") { CHECK(chosen(1.0, 4).map == 512); }

// A cell over the whole map covers all its texels, and 96 x 96 of them at 512 21 ns * 9216 * 512^2 = 50 s:
// the time grows with the map's area, 2.25-fold to 768.
TEST_CASE("picture sides: no finer than in twice the time") {
  const Window everywhere{glm::dvec2(-1.0), glm::dvec2(1.0)};
  CHECK(chosen(1.0, 1, std::vector<Window>(9216, everywhere)).map == 512);
  CHECK(chosen(1.0, 1, {everywhere}).map == 1280);
}

TEST_CASE("picture sides: chosen only where both are left to the frame, for cells, on water at rest") {
  Scene scene;
  Settings settings;
  CHECK(chooses_sides(scene, settings));
  settings.splat = Splat::Gaussian;
  CHECK_FALSE(chooses_sides(scene, settings));
  settings = {};
  settings.map = 512;
  CHECK_FALSE(chooses_sides(scene, settings));
  scene.waters.emplace_back();
  CHECK_FALSE(chooses_sides(scene, Settings{}));
}

TEST_CASE("picture sides: least sides are as if given") {
  const Settings least = with_least_sides(Settings{});
  CHECK(least.grid == 512);
  CHECK_FALSE(least.grid.automatic);
  CHECK_FALSE(least.map.automatic);
}
