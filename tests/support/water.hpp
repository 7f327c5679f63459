// Water surfaces in memory, for tests.
#pragma once
#include <cmath>

#include "pipeline/scene/water.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scenes.hpp"

namespace caustics::test {

// A grid without a scene: cells of 1 m, waves of 1 m/s, steps of half a second, and no plop for ages.
inline Water bare_water(int columns, int rows, double damping = 0.0) {
  Water water;
  water.settings.speed = 1.0;
  water.settings.damping = damping;
  water.columns = columns;
  water.rows = rows;
  water.dx = water.dz = 1.0;
  water.step = 0.5;
  water.radius = 4.0;
  water.height = 1.0;
  water.steps_per_plop = 1'000'000;
  return water;
}

// A floor of 2 x 2 m and water of the same size over it; a vertical light of 1 lux, and an orthographic
// camera between the two that looks down on the floor.
inline Scene pool_scene(double depth, const WaterSettings& settings) {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.33f)};
  scene.meshes = {floor(1.0, 0.0, 0), floor(1.0, depth, 1)};
  scene.meshes[1].name = "pool";
  scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
  scene.cameras = {camera_down(0.5 * depth, 1.0)};
  REQUIRE(add_water(scene, 1, {1.0, 0.0, 0.0}, settings) == "");
  return scene;
}

}  // namespace caustics::test
