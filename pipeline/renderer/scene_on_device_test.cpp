#include "pipeline/renderer/scene_on_device.hpp"

#include "raster/software_device.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("scene on device: each caster has a row of its own, whatever its material") {
  // So a grid vertex tells which caster it lies on, and what became of the light of each.
  Scene scene = sphere_scene(1.5f, 1);
  scene.meshes.push_back(sphere({2.0, 0.8, 0.0}, 0.5, 1, 1));
  const auto device = make_software_device({.threads = 1});
  const SceneOnDevice on_device(scene, effects_of(scene, {}), *device);
  CHECK(on_device.material_row(1) == 0);
  CHECK(on_device.material_row(2) == 1);
}
