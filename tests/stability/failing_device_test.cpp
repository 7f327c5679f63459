// A device that fails at any of its calls: the error comes out as it is, nothing is left on the device, and
// the next frame on it is drawn as if nothing had been.
#include <new>
#include <set>

#include "pipeline/gpu/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/forwarding_device.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

enum class Fault { DriverError, OutOfMemory };

// Counts the calls that can fail, fails at one of them, and knows what exists on it.
class FailingDevice final : public ForwardingDevice {
 public:
  FailingDevice(int fails_at, Fault fault) : fails_at_(fails_at), fault_(fault) {}

  TextureId create_texture(Format format, int width, int height) override {
    call("create_texture");
    return *textures_.insert(ForwardingDevice::create_texture(format, width, height)).first;
  }
  TextureId upload(const Image& image) override {
    call("upload");
    return *textures_.insert(ForwardingDevice::upload(image)).first;
  }
  void destroy(TextureId texture) override {
    CHECK(textures_.erase(texture) == 1);
    ForwardingDevice::destroy(texture);
  }
  MeshId create_mesh(const MeshData& mesh) override {
    call("create_mesh");
    return *meshes_.insert(ForwardingDevice::create_mesh(mesh)).first;
  }
  void update(MeshId mesh, const MeshData& data) override {
    call("update");
    ForwardingDevice::update(mesh, data);
  }
  void destroy(MeshId mesh) override {
    CHECK(meshes_.erase(mesh) == 1);
    ForwardingDevice::destroy(mesh);
  }
  PassResult run(const PassRun& run) override {
    call("run");
    return ForwardingDevice::run(run);
  }
  void finish() override {
    call("finish");
    ForwardingDevice::finish();
  }
  Image read_back(TextureId texture) override {
    call("read_back");
    return ForwardingDevice::read_back(texture);
  }

  void mend() { fails_at_ = -1; }
  int calls() const { return calls_; }
  std::size_t objects() const { return textures_.size() + meshes_.size(); }
  const std::string& failed_call() const { return failed_call_; }

 private:
  void call(const char* name) {
    if (calls_++ != fails_at_) return;
    failed_call_ = name;
    if (fault_ == Fault::OutOfMemory) throw std::bad_alloc();
    throw Error(ExitCode::BackendUnavailable, std::string(name) + " failed: the context is lost");
  }

  int calls_ = 0, fails_at_;
  Fault fault_;
  std::string failed_call_;
  std::set<TextureId> textures_;
  std::set<MeshId> meshes_;
};

Scene small_scene() {
  Scene scene = sphere_scene(1.5f, 2);
  Light lamp{.name = "lamp", .type = LightType::Point, .intensity = 1.0f};
  lamp.position = {0.3, 2.0, 0.2};
  scene.lights.push_back(lamp);
  return scene;
}

const Settings kSettings = small_settings(16, 16, 8);

#ifdef CAUSTICS_SANITIZED
constexpr int kStep = 29;  // a frame takes twenty times as long
#else
constexpr int kStep = 7;
#endif

std::string picture_on(Device& device) {
  return sha256(render_on(device, small_scene(), kSettings, {})["picture"]);
}

// The error that a frame ends with.
std::string error_of(FailingDevice& device) {
  try {
    picture_on(device);
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::BackendUnavailable);
    return error.what();
  } catch (const std::bad_alloc&) {
    return "out of memory";
  }
  return "";
}

}  // namespace

TEST_CASE("failing device: an error at any call comes out, leaves nothing behind, and the device goes on") {
  FailingDevice whole(-1, Fault::DriverError);
  const std::string expected = picture_on(whole);
  CHECK(whole.objects() == 0);
  REQUIRE(whole.calls() > 100);
  std::set<std::string> failed;
  for (const Fault fault : {Fault::DriverError, Fault::OutOfMemory})
    // Every call where a frame's kinds of calls change, and some between.
    for (int n = 0; n < whole.calls(); n += n < 40 ? 1 : kStep) {
      FailingDevice device(n, fault);
      INFO("call " << n);
      const std::string error = error_of(device);
      failed.insert(device.failed_call());
      if (fault == Fault::DriverError) {
        CHECK(error == device.failed_call() + " failed: the context is lost");
      } else {
        CHECK(error == "out of memory");
      }
      CHECK(device.objects() == 0);
      if (n % 20 != 0) continue;
      device.mend();
      CHECK(picture_on(device) == expected);
    }
  CHECK(failed == std::set<std::string>{"create_mesh", "create_texture", "read_back", "run", "upload"});
}
