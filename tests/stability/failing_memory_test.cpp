// Memory that runs out at any allocation of a frame: std::bad_alloc comes out, nothing is left on the device,
// and the next frame on it is drawn as if nothing had been.
#include <new>

#include "tests/support/catch.hpp"
#include "tests/support/failing_new.hpp"
#include "tests/support/forwarding_device.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Counts what exists on it, without memory of its own.
class CountingDevice final : public ForwardingDevice {
 public:
  CountingDevice() : ForwardingDevice(make_software_device({.threads = 1})) {}
  TextureId create_texture(Format format, int width, int height) override {
    const TextureId id = ForwardingDevice::create_texture(format, width, height);
    ++objects_;
    return id;
  }
  TextureId upload(const Image& image) override {
    const TextureId id = ForwardingDevice::upload(image);
    ++objects_;
    return id;
  }
  MeshId create_mesh(const MeshData& mesh) override {
    const MeshId id = ForwardingDevice::create_mesh(mesh);
    ++objects_;
    return id;
  }
  void destroy(TextureId texture) override {
    ForwardingDevice::destroy(texture);
    --objects_;
  }
  void destroy(MeshId mesh) override {
    ForwardingDevice::destroy(mesh);
    --objects_;
  }
  int objects() const { return objects_; }

 private:
  int objects_ = 0;
};

}  // namespace

TEST_CASE(
    "failing memory: an allocation of a frame that fails comes out, leaves nothing behind, and the device "
    "goes on") {
  const Scene scene = sphere_scene(1.5f, 2);
  Settings settings = small_settings(16, 16, 8);
  settings.splits = 0;  // of light that is followed, few passes
  settings.bounces = 2;
  CountingDevice device;
  const auto view = [&] { return render_on(device, scene, settings, {}); };
  const std::string expected = sha256(view()["picture"]);
  int failures = 0;
  // One by one at first; of the many alike that follow, a few.
  for (int n = 0;; n += n < 100 ? 1 : 97) {
    bool thrown = false, failed = false;
    {
      const FailingNew memory(n);
      try {
        view();
      } catch (const std::bad_alloc&) {
        thrown = true;
      }
      failed = memory.failed();
    }
    if (!failed) break;
    INFO("allocation " << n);
    CHECK(thrown);
    CHECK(device.objects() == 0);
    if (++failures % 100 == 0) CHECK(sha256(view()["picture"]) == expected);
  }
  CHECK(failures > 100);
  CHECK(sha256(view()["picture"]) == expected);
}
