#include "pipeline/scene/lamp_level.hpp"

#include "pipeline/scene/defaults.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A level floor of 2 km, and a lamp of 100 cd over it.
Scene lamp_over_floor(double height) {
  Scene scene;
  scene.materials = {diffuse(0.8f)};
  scene.meshes = {floor(1000.0, 0.0, 0)};
  Light lamp;
  lamp.type = LightType::Point;
  lamp.intensity = 100.0f;
  lamp.position = {0, height, 0};
  scene.lights = {lamp};
  return scene;
}

}  // namespace

// Within an angle t of straight down goes 1 - cos t of the light that meets the floor: a quarter where
// cos t = 3/4, and there it is I cos^3 t / h^2 = 27/64 I / h^2. 128 rays down tell cos t to 1/128.
TEST_CASE("The lamps' level: a quarter of their light falls where it is brighter") {
  CHECK(lamp_level(lamp_over_floor(5.0)) == Approx(27.0 / 64.0 * 4.0).epsilon(0.04));
  // Thrice as high, a ninth: it does not matter how large the floor is.
  CHECK(light_level(lamp_over_floor(15.0)) == Approx(27.0 / 64.0 * 4.0 / 9.0).epsilon(0.04));
}

TEST_CASE(
    "The lamps' level: two samples of one lamp are as bright as it, and what it does not reach counts for "
    "nothing") {
  Scene scene = lamp_over_floor(5.0);
  const double one = lamp_level(scene);
  scene.lights[0].intensity = 50.0f;
  scene.lights[0].source = 0;
  scene.lights.push_back(scene.lights[0]);
  CHECK(lamp_level(scene) == Approx(one));
  scene.meshes.clear();
  CHECK(lamp_level(scene) == 0.0);
}

TEST_CASE("The light's level with a caster is that on it, though an added ground reaches far") {
  Scene scene = lamp_over_floor(5.0);
  scene.materials.push_back(glass(1.5f));
  scene.meshes = {sphere(glm::dvec3(0.0), 1.0, 2, 1)};
  add_ground(scene, subject_of(scene), -1.0);
  CHECK(light_level(scene) == Approx(4.0));
}

TEST_CASE(
    "The light's level is that of its lamps' distance and side, never from nearer than what they light is "
    "wide") {
  Scene scene;
  scene.materials = {glass(1.5f)};
  scene.meshes = {sphere(glm::dvec3(0.0, 1.0, 0.0), 0.5, 2, 0)};
  Light lamp{.name = "lamp", .type = LightType::Point, .intensity = 8.0f};
  lamp.position = {0.0, 3.0, 0.0};
  scene.lights = {lamp};
  CHECK(light_level(scene) == Approx(2.0));
  scene.lights[0].color = {1.0f, 0.0f, 0.0f};  // whose luminance is 0.2126
  CHECK(light_level(scene) == Approx(2.0 * 0.2126));
  scene.lights[0] = lamp;
  scene.lights[0].position = {0.0, 1.1, 0.0};
  CHECK(light_level(scene) == Approx(8.0 / (subject_of(scene).radius() * subject_of(scene).radius())));
  scene.lights[0] = lamp;
  scene.lights[0].lambertian = true;
  scene.lights[0].direction = {0.6, -0.8, 0.0};
  CHECK(light_level(scene) == Approx(2.0 * 0.8));
  scene.lights[0].direction = {0.0, 1.0, 0.0};
  CHECK(light_level(scene) == 0.0);
}
