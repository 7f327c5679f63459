#include "pipeline/renderer/light_pilot.hpp"

#include <algorithm>

#include "passes/registry.hpp"
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

}  // namespace

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
