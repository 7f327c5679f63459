// How bright a picture is made, by what it shows.
#include "pipeline/renderer/exposure.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pilot.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A floor of albedo 0.8 seen from straight above, under a vertical sun of pi lux: 0.8 nit.
Scene lit_floor(float lux = 3.14159265f) {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = {floor(8.0, 0.0, 0)};
  scene.lights = {sun({0.0, -1.0, 0.0}, lux)};
  scene.cameras = {camera_down(0.5, 2.0)};
  return scene;
}

Exposure exposure_for(const Scene& scene, const Settings& settings = {}) {
  return exposure_of(scene, settings, view_of(scene.cameras.front(), 160, 90, bounds_of(scene)), pilot());
}

// What tone_map makes of a radiance before its shoulder: a power about 0.31.
double shown(const Exposure& exposure, double radiance) {
  const double exposed = radiance * static_cast<double>(exposure.factor);
  return exposed * std::pow(exposed / 0.31, static_cast<double>(exposure.contrast) - 1.0);
}

}  // namespace

TEST_CASE("exposure: an even floor is shown as a mid grey, whatever the light's strength") {
  for (const float lux : {1e-6f, 3.14159265f, 1e6f}) {
    const Exposure exposure = exposure_for(lit_floor(lux));
    CHECK(shown(exposure, 0.8 * static_cast<double>(lux) / 3.14159265) == Approx(0.31).epsilon(1e-3));
    CHECK(exposure.contrast == Approx(6.0));
  }
}

TEST_CASE("exposure: a floor in shadow but for one bright part keeps it below 7.6 times white") {
  // A lid over all but a slit of 0.4 of 4 m: what glows is sunlit, the floor as dark as the environment
  // leaves it.
  Scene scene = lit_floor();
  scene.environment.zenith = scene.environment.horizon = glm::vec3(1e-3f);
  for (const double side : {-1.0, 1.0})
    scene.meshes.push_back(box({side < 0 ? -8.0 : 0.2, 1.0, -8.0}, {side < 0 ? -0.2 : 8.0, 1.1, 8.0}, 0));
  const Exposure exposure = exposure_for(scene);
  CHECK(exposure.contrast == 1.0f);
  CHECK(shown(exposure, 0.8) == Approx(7.6).epsilon(0.01));
}

TEST_CASE("exposure: what glass gathers on the floor is brought to white") {
  Scene scene = lit_floor();
  scene.meshes.push_back(sphere({0.0, 1.5, 0.0}, 0.8, 4, 1));
  const Exposure exposure = exposure_for(scene);
  CHECK(shown(exposure, 0.8) == Approx(0.31).epsilon(0.01));
  // Light of the ball lands on some hundred times less than its own area: far brighter than white.
  CHECK(shown(exposure, 8.0) > 0.95);
  CHECK(exposure.contrast < 6.0f);
}

TEST_CASE("exposure: a small caustic is seen as bright as it is, not as the mean over what lies around it") {
  // The floor lies near the ball's focus, 1.5 radii below its middle: a spot of some hundredths of a metre.
  Scene scene = lit_floor();
  scene.meshes.push_back(sphere({0.0, 0.31, 0.0}, 0.2, 4, 1));
  scene.cameras = {camera_down(1.0, 0.8)};
  const Exposure exposure = exposure_for(scene);
  CHECK(exposure.contrast < 2.0f);
  CHECK(shown(exposure, 0.8) == Approx(0.31).epsilon(0.01));
}

TEST_CASE("exposure: white that fills much of the picture keeps its texture") {
  // A white table on a third of a picture, twice as bright as the floor: 0.31 * 2^c = 0.8 with c = 1.368.
  Scene scene = lit_floor();
  scene.materials[0].base_color = glm::vec4(0.4f, 0.4f, 0.4f, 1.0f);
  scene.materials.push_back(diffuse(0.8f));
  scene.meshes.push_back(box({-9.0, 0.0, -9.0}, {-1.2, 0.1, 9.0}, 2));
  CHECK(shown(exposure_for(scene), 0.8) == Approx(0.8).epsilon(0.02));
}

TEST_CASE("exposure: a floor's picture counts with the mean of all its rows and columns") {
  // One texel of 16 is white, the others are of 0.2: 0.25 in the mean, of the floor's 0.8.
  for (const bool upright : {false, true}) {
    Scene scene = lit_floor();
    Image picture(Format::RGBA32F, upright ? 1 : 16, upright ? 16 : 1);
    std::fill(picture.values.begin(), picture.values.end(), 0.2f);
    std::fill_n(picture.values.begin(), 4, 1.0f);
    scene.images = {picture};
    scene.materials[0].base_color_texture.image = 0;
    CHECK(shown(exposure_for(scene), 0.25 * 0.8) == Approx(0.31).epsilon(1e-3));
  }
}

TEST_CASE("exposure: metal has no colour of its own that would glow") {
  const auto with = [](float metallic) {
    Scene scene = lit_floor();
    scene.materials[0].base_color = glm::vec4(0.2f, 0.2f, 0.2f, 1.0f);
    scene.materials.push_back(diffuse(0.9f));
    scene.materials.back().metallic = metallic;
    scene.meshes.push_back(box({-0.1, 0.0, -0.1}, {0.1, 0.1, 0.1}, 2));
    return exposure_for(scene);
  };
  // 4.5 times as bright as the floor: 0.31 * 4.5 is over 1.15. Of metal nothing is brighter than the floor.
  CHECK(with(0.0f).contrast == 1.0f);
  CHECK(with(1.0f).contrast == Approx(6.0));
}

TEST_CASE("exposure: where a bright sky is over half of the picture, the floor under it is shown darker") {
  Scene scene = lit_floor();
  scene.environment.backdrop = glm::vec3(2.3f);
  Camera level = scene.cameras.front();
  scene.meshes = {box({-1.0, -0.1, -1.0}, {1.0, 0.0, 0.0}, 0)};
  scene.cameras = {level};
  const auto whole =
      exposure_of(scene, {}, view_of(camera_down(2.0, 2.0), 160, 90, bounds_of(scene)), pilot());
  CHECK(static_cast<double>(whole.factor) * 2.3 == Approx(0.31 * 1.15).epsilon(1e-3));
}

TEST_CASE("exposure: it asks neither for the grid nor for the picture's size, and adds EV") {
  Scene scene = lit_floor();
  scene.meshes.push_back(sphere({0.0, 1.5, 0.0}, 0.8, 3, 1));
  Settings settings;
  const Exposure exposure = exposure_for(scene);
  settings.grid = 64;
  CHECK(exposure_for(scene, settings).factor == exposure.factor);
  settings.exposure = 1.5f;
  CHECK(exposure_for(scene, settings).factor == Approx(exposure.factor * std::sqrt(8.0)));
  CHECK(exposure_for(scene, settings).contrast == exposure.contrast);
}

TEST_CASE("exposure: a scene without light, and one without anything, have a finite one") {
  Scene dark = lit_floor(0.0f);
  CHECK(std::isfinite(exposure_for(dark).factor));
  CHECK(exposure_of(Scene{}, {}, {}, pilot()).factor > 0.0f);
}
