#include "pipeline/renderer/landed_light.hpp"

#include "pipeline/scene/defaults.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pilot.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A glass ball of radius 1 on a ground, under a sun that stands 60 degrees high.
Scene ball() {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = {sphere(glm::dvec3(0.0), 1.0, 3, 1)};
  add_ground(scene, subject_of(scene), -1.0);
  set_sun(scene, {0.5, -0.8660254, 0.0}, 10.0f);
  return scene;
}

glm::dvec3 middle_of(const std::vector<Landed>& landed) {
  glm::dvec3 middle(0.0);
  for (const Landed& each : landed) middle += each.position * each.share;
  return middle;
}

}  // namespace

TEST_CASE("landed light: the same rays are followed whatever the grid is") {
  const Scene scene = ball();
  Settings fine, coarse;
  coarse.grid = 64;
  const std::vector<Landed> by_fine = LandedLight(scene, fine, pilot()).find(),
                            by_coarse = LandedLight(scene, coarse, pilot()).find();
  REQUIRE(by_fine.size() == by_coarse.size());
  REQUIRE_FALSE(by_fine.empty());
  for (std::size_t i = 0; i < by_fine.size(); ++i) CHECK(by_fine[i].position == by_coarse[i].position);
}

TEST_CASE("landed light: a quarter of the rays tells where it lands, and how much") {
  const Scene scene = ball();
  const Settings settings;
  LandedLight light(scene, settings, pilot());
  const std::vector<Landed> by_all = light.find(), by_some = light.find(2);
  CHECK(by_some.size() < by_all.size() / 3);
  CHECK(glm::length(middle_of(by_all) - middle_of(by_some)) < 0.1);
  double all = 0.0, some = 0.0;
  for (const Landed& each : by_all) all += each.area;
  for (const Landed& each : by_some) some += each.area;
  // The ball is pi square metres wide across the light, and mirrors 8 % or so of it.
  CHECK(all == Approx(some).epsilon(0.05));
  CHECK(all == Approx(0.92 * 3.14159).epsilon(0.1));
}

TEST_CASE("landed light: a sun that has been turned lands its light elsewhere") {
  Scene scene = ball();
  const Settings settings;
  LandedLight light(scene, settings, pilot());
  CHECK(middle_of(light.find()).x > 0.2);
  set_sun(scene, {-0.5, -0.8660254, 0.0}, 10.0f);
  CHECK(middle_of(light.find()).x < -0.2);
}
