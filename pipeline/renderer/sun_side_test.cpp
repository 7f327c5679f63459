#include "pipeline/renderer/sun_side.hpp"

#include <string>

#include "pipeline/renderer/landed_light.hpp"
#include "pipeline/scene/defaults.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pilot.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr glm::dvec3 kFront{0.0, 0.0, 1.0};

// A glass ball of radius 1 above a ground, 2 m before a board where one is asked for; the camera looks along
// -z.
Scene ball(bool board) {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = {sphere(glm::dvec3(0.0), 1.0, 2, 1)};
  if (board) scene.meshes.push_back(box({-3.0, -1.0, -2.2}, {3.0, 4.0, -2.0}, 0));
  add_ground(scene, subject_of(scene), -1.0);
  set_sun(scene, {0.0, -1.0, 0.0}, 10.0f);
  return scene;
}

SunSide side_of(Scene scene, const glm::dvec3& toward_camera = kFront) {
  const Settings settings;
  LandedLight landed(scene, settings, pilot());
  return sun_side(scene, landed, toward_camera, kFront);
}

}  // namespace

TEST_CASE(
    "sun side: of bare glass the light comes from behind, 60 degrees high, towards the camera's right") {
  const SunSide side = side_of(ball(false));
  CHECK(std::string(side.where) == "behind");
  CHECK(glm::length(side.direction - glm::dvec3(0.3, -0.8660254, 0.4)) < 1e-6);
}

TEST_CASE("sun side: a board behind the glass is lit from before, and shows its caustic") {
  const SunSide side = side_of(ball(true));
  CHECK(std::string(side.where) == "before");
  CHECK(glm::length(side.direction) == Approx(1.0));
  CHECK(side.direction.z < -0.4);
  CHECK(side.direction.x > 0.0);
}

TEST_CASE("sun side: a backdrop does not throw its own shadow over the floor that catches the light") {
  Scene scene = ball(false);
  scene.meshes.front() = box({-6.0, -1.1, -3.0}, {6.0, -1.0, 9.0}, 0);
  scene.meshes.back() = box({-6.0, -1.0, -3.1}, {6.0, 4.0, -3.0}, 0);
  scene.meshes.push_back(sphere(glm::dvec3(0.0), 1.0, 2, 1));
  const glm::dvec3 above{0.0, 0.8, 0.6};
  CHECK(std::string(side_of(scene, above).where) != "behind");
}

TEST_CASE("sun side: the sun stays behind what it shines on enough, as the camera sees it") {
  // Of a grey ball the camera sees the lit top from above, and hardly any of it from the side.
  Scene scene = ball(false);
  scene.meshes.insert(scene.meshes.begin(), sphere({3.0, 0.0, 0.0}, 1.0, 3, 0));
  const glm::dvec3 above{0.0, 0.8, 0.6};
  CHECK(std::string(side_of(scene, above).where) == "behind");
  CHECK(std::string(side_of(scene).where) != "behind");
}
