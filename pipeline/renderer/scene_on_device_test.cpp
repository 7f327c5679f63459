#include "pipeline/renderer/scene_on_device.hpp"

#include "passes/tone_map/tone_map.hpp"
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
  CHECK(on_device.tables().material_row(1) == 0);
  CHECK(on_device.tables().material_row(2) == 1);
}

TEST_CASE("scene on device: the software device reads images where they lie, and draws into none") {
  Scene scene = sphere_scene(1.5f, 1);
  scene.images.emplace_back(Format::RGBA8, 2, 2);
  const auto device = make_software_device({.threads = 1});
  const SceneOnDevice on_device(scene, effects_of(scene, {}), *device);
  CHECK(device->look_at(on_device.image(0)).values.data() == scene.images[0].values.data());
  const TextureId source = device->create_texture(Format::RGBA32F, 2, 2);
  const Pass pass = tone_map_pass();
  const PassDefinition definition = definition_of(pass);
  PassRun run{.definition = &definition, .colors = {on_device.image(0)}};
  run.draws.push_back({.vertex_count = 3, .uniforms = pass.uniforms({}), .textures = {source}});
  CHECK_THROWS_WITH(device->run(run), "a shared image is drawn into");
}
