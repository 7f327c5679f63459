#include "pipeline/renderer/run_plan.hpp"

#include "pipeline/gpu/interrupt.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/forwarding_device.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A device on which work is asked to stop while it makes its second texture.
class StoppedDevice : public ForwardingDevice {
 public:
  TextureId create_texture(Format format, int width, int height) override {
    if (++made_ == 2) ask_to_stop(ExitCode::Interrupted);
    return ForwardingDevice::create_texture(format, width, height);
  }
  void destroy(TextureId texture) override {
    ++destroyed_;
    ForwardingDevice::destroy(texture);
  }
  int made_ = 0, destroyed_ = 0;
};

}  // namespace

TEST_CASE("frame targets: making textures hears an interrupt, and leaves none behind") {
  FramePlan plan;
  plan.memory.resize(5, {Format::R32F, 4, 4});
  StoppedDevice device;
  CHECK_THROWS_AS(FrameTargets(plan, device), Error);
  ask_to_stop(ExitCode::Done);
  CHECK(device.made_ == 2);
  CHECK(device.destroyed_ == 2);
}
