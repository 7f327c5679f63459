#include "pipeline/renderer/light_pilot.hpp"

#include <algorithm>

#include "passes/registry.hpp"
#include "pipeline/effects/drawn_sizes.hpp"
#include "pipeline/scene/light_samples.hpp"
#include "raster/software_device.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/forwarding_device.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Remembers the largest texture that was drawn into.
class MeasuringDevice final : public ForwardingDevice {
 public:
  int largest = 0;
  TextureId create_texture(Format format, int width, int height) override {
    largest = std::max({largest, width, height});
    return ForwardingDevice::create_texture(format, width, height);
  }
};

// From how far behind a lamp of radius 0.3 m, 2.4 m above the floor, this is seen.
double steps_back(const Mesh& caster) {
  Scene scene;
  scene.materials = {diffuse(0.8f), metal(glm::vec3(1.0f))};
  scene.meshes = {floor(3.0, 0.0, 0), caster};
  scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
  scene.cameras = {camera_down(0.2, 1.0)};
  Light& lamp = scene.lights.front();
  lamp.type = LightType::Point;
  lamp.position = {0.0, 2.4, 0.0};
  lamp.shape = LightShape::Sphere;
  lamp.radius = 0.3;
  sample_lights(scene, 4);
  const Settings settings = small_settings(32, 32, 16);
  const Effects effects = with_drawn_sizes(effects_of(scene, settings), scene, settings);
  const std::unique_ptr<Device> device = make_software_device({.threads = 1});
  const SceneOnDevice on_device(scene, effects, *device);
  const std::vector<FurtherShare> shares =
      LightPilot(on_device, pass_registry()).further_shares(effects, settings, nullptr);
  REQUIRE(shares.size() == 1);
  return shares.front().steps_back;
}

}  // namespace

TEST_CASE("light pilot: round bodies are seen from behind a lamp, walls along the light from where it is") {
  CHECK(steps_back(sphere({0.0, 0.8, 0.0}, 0.5, 3, 1)) >= 1.0);
  CHECK(steps_back(half_ring(0.5, 0.8, 16, 1)) <= 0.5);
}

TEST_CASE("light pilot: it looks for landings on maps of 256 texels at most, however fine the frame's are") {
  const Scene scene = sphere_scene(1.5f, 2);
  for (const auto& [map, expected] : {std::pair{128, 128}, {1024, 256}}) {
    const Settings settings = small_settings(32, map, 16);
    const Effects effects = effects_of(scene, settings);
    MeasuringDevice device;
    const SceneOnDevice on_device(scene, effects, device);
    device.largest = 0;
    fit_light_views(on_device, effects, settings, pass_registry());
    CHECK(device.largest == expected);
  }
}
