#include "pipeline/effects/effects.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("lit surfaces: a light counts if it reaches any of them, whichever comes first in the scene") {
  const Mesh lit = box({-1, -0.1, -1}, {1, 0, 1}, 0), dark = box({20, -0.1, -1}, {22, 0, 1}, 0);
  Scene scene;
  scene.materials = {diffuse(0.8f)};
  Light spot{.name = "spot", .type = LightType::Spot};
  spot.position = {0, 2, 0};
  spot.direction = {0, -1, 0};
  spot.outer_cone = 0.3f;
  scene.lights = {spot};
  for (const std::vector<Mesh>& meshes : {std::vector{lit, dark}, {dark, lit}}) {
    scene.meshes = meshes;
    CHECK(effects_of(scene, Settings{}).lights[0].lights_nothing.empty());
    CHECK(effects_of(scene, Settings{}).light.active);
  }
  scene.meshes = {dark, dark};
  CHECK(effects_of(scene, Settings{}).lights[0].lights_nothing == "the spot light's cone misses it");
  CHECK_FALSE(effects_of(scene, Settings{}).light.active);
}
