// What the camera sees of the floor: identities that hold whatever the numbers.
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

const std::vector<std::string> kLayers = {"aov_direct", "aov_caustic", "aov_position", "beauty"};

double irradiance(const Rendering& r, int x, int y) {
  return double(r["aov_direct"].at(x, y, 0)) + double(r["aov_caustic"].at(x, y, 0));
}

// Distance of a pixel's centre from the picture's middle, metres, over a floor of 2 x 2 m.
double radius(int x, int y, int picture) {
  const double px = (x + 0.5) / picture * 2.0 - 1.0, py = (y + 0.5) / picture * 2.0 - 1.0;
  return std::sqrt(px * px + py * py);
}

}  // namespace

TEST_CASE("floor: glass of index 1 leaves no trace but at the shadow's edge") {
  // The caustic must fill the shadow exactly. The kernel's radius (2.1 texels) plus two texels of the map,
  // 1.06 m / 256 each, is 17 mm. A pixel, 3.8 texels wide, is averaged over sqrt(3.8^2 - 3) texels, whose
  // corners are 10 mm from its middle.
  Settings settings = small_settings(256, 256, 128);
  const Rendering with = render(sphere_scene(1.0f), settings, kLayers);
  double worst = 0.0;
  bool shadowed = false;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      if (std::fabs(radius(x, y, 128) - 0.5) < 0.028) continue;
      worst = std::max(worst, std::fabs(irradiance(with, x, y) - 1.0));
      shadowed |= with["aov_direct"].at(x, y, 0) == 0.0f;
    }
  CHECK(shadowed);
  CHECK(worst < 1e-3);
}

TEST_CASE("floor: with point splats and coinciding frames glass of index 1 leaves no trace at all") {
  Settings settings = small_settings(128, 128, 128);
  settings.splat = Splat::Point;
  settings.shared_views = true;
  const Rendering with = render(sphere_scene(1.0f), settings, kLayers);
  double worst = 0.0;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) worst = std::max(worst, std::fabs(irradiance(with, x, y) - 1.0));
  CHECK(worst < 1e-3);
}

TEST_CASE("floor: glass of index 1.5 does leave a trace") {
  Settings settings = small_settings(128, 128, 64);
  const Rendering with = render(sphere_scene(1.5f), settings, kLayers);
  CHECK(with["aov_caustic"].at(32, 32, 0) > 5.0f);
}

TEST_CASE("floor: twice the light, by one twice as strong or by two, gives exactly twice the irradiance") {
  Settings settings = small_settings(64, 64, 32);
  Scene strong = sphere_scene(1.5f), two = strong;
  strong.lights[0].intensity = 2.0f;
  two.lights.push_back(two.lights[0]);
  const Rendering one = render(sphere_scene(1.5f), settings, kLayers);
  for (const Scene& scene : {strong, two}) {
    const Rendering twice = render(scene, settings, kLayers);
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) CHECK(irradiance(twice, x, y) == 2.0 * irradiance(one, x, y));
  }
}

TEST_CASE("floor: a very distant point light is a directional one") {
  // 1000 m away the rays over the sphere differ by 5e-4 rad: 0.4 mm on the floor.
  Settings settings = small_settings(128, 128, 64);
  Scene scene = sphere_scene(1.5f);
  const Rendering sun_lit = render(scene, settings, kLayers);
  Light point{.name = "point", .type = LightType::Point, .intensity = 1e6f};
  point.position = {0.0, 1000.0, 0.0};
  scene.lights = {point};
  const Rendering point_lit = render(scene, settings, kLayers);
  double difference = 0.0, total = 0.0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      difference += std::fabs(irradiance(point_lit, x, y) - irradiance(sun_lit, x, y));
      total += irradiance(sun_lit, x, y);
    }
  CHECK(difference / total < 0.02);
}

TEST_CASE("floor: from the centre of a glass sphere light leaves undeviated and loses R0") {
  // R0 = 0.04 for n = 1.5. Right below the light, 0.8 m: E = 0.96 I / 0.64.
  Settings settings = through_two_surfaces(small_settings(128, 128, 64));
  Scene scene = sphere_scene(1.5f);
  Light point{.name = "point", .type = LightType::Point, .intensity = 1.0f};
  point.position = {0.0, 0.8, 0.0};
  scene.lights = {point};
  const Rendering r = render(scene, settings, kLayers);
  CHECK(irradiance(r, 32, 32) == Approx(0.96 / 0.64).epsilon(0.02));
}

TEST_CASE("floor: beauty is albedo over pi times all irradiance") {
  Settings settings = small_settings(64, 64, 32);
  settings.highlights = false;
  Scene scene = sphere_scene(1.5f);
  scene.environment = {};  // no ambient light
  const Rendering r = render(scene, settings, kLayers);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      CHECK(double(r["beauty"].at(x, y, 0)) ==
            Approx(0.8 / 3.14159265358979 * irradiance(r, x, y)).epsilon(1e-5).margin(1e-9));
}

TEST_CASE("floor: a thin pane tints its shadow and leaves the rest alone") {
  // A level pane of +-0.5 m: a vertical ray keeps 0.96 / 1.04 of its light, times the pane's colour.
  Scene scene = without_casters(sphere_scene(1.5f));
  Material pane = glass(1.5f);
  pane.thickness = 0.0f;
  pane.base_color = {0.2f, 0.4f, 0.8f, 1.0f};
  scene.materials.push_back(pane);
  scene.meshes.push_back(floor(0.5, 0.8, 2));
  const Rendering r = render(scene, small_settings(64, 64, 64), kLayers);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const double px = std::fabs((x + 0.5) / 32.0 - 1.0), py = std::fabs((y + 0.5) / 32.0 - 1.0);
      if (std::fabs(px - 0.5) < 0.02 || std::fabs(py - 0.5) < 0.02) continue;
      const bool under = px < 0.5 && py < 0.5;
      for (int c = 0; c < 3; ++c) {
        const double tint = under ? pane.base_color[c] * 0.96 / 1.04 : 1.0;
        CHECK(r["aov_direct"].at(x, y, c) == Approx(tint).epsilon(1e-5));
      }
      CHECK(r["aov_caustic"].at(x, y, 0) == 0.0f);
    }
}
