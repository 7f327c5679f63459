// Whole frames: the comparison itself on two software devices, then software against OpenGL.
#include <algorithm>
#include <set>

#include "passes/parity_allowances.hpp"
#include "passes/registry.hpp"
#include "pipeline/renderer/frame_renderer.hpp"
#include "pipeline/renderer/parity.hpp"
#include "tests/parity/match.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/forwarding_device.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Glass and diffuse bodies, a box that the view cuts off, a thin pane, a mirror, an absorbing
// medium, three kinds of light.
Scene frame_scene() {
  Scene scene = sphere_scene(1.5f, 4);
  scene.materials[1].attenuation_distance = 0.5f;
  scene.materials[1].attenuation_color = {0.9f, 0.5f, 0.3f};
  Material pane = glass(1.5f);
  pane.thickness = 0.0f;
  pane.base_color = {0.9f, 0.6f, 0.3f, 1.0f};
  scene.materials.push_back(pane);
  scene.materials.push_back(metal({0.95f, 0.64f, 0.54f}));
  scene.meshes.push_back(half_ring(0.9, 0.2, 24, 3));
  scene.meshes.push_back(box({-1.4, 0.0, -0.9}, {-0.6, 0.15, -0.4}, 0));
  scene.meshes.push_back(box({0.4, 0.2, 0.3}, {0.9, 0.6, 0.7}, 1));
  scene.meshes.push_back(floor(0.4, 0.1, 2));
  scene.lights = {sun({0.3, -1.0, -0.2}, 2.0f)};
  Light point{.name = "point", .type = LightType::Point, .intensity = 3.0f};
  point.position = {-0.8, 2.0, 0.6};
  scene.lights.push_back(point);
  Light panel = point;
  panel.position = {0.9, 1.5, -0.8};
  panel.direction = glm::normalize(glm::dvec3(-0.5, -1.0, 0.6));
  panel.lambertian = true;
  scene.lights.push_back(panel);
  return scene;
}

// The same with textures of every kind on glass and metal, holes included.
Scene textured_scene() {
  Scene scene = frame_scene();
  for (const Format format : {Format::RGBA16F, Format::RGBA32F, Format::RGBA32F}) {
    Image image(format, 5, 3);
    for (std::size_t i = 0; i < image.values.size(); ++i)
      image.values[i] = stored_value(format, static_cast<float>((i * 37 + 11) % 256) / 255.0f);
    scene.images.push_back(image);
  }
  for (Mesh& mesh : scene.meshes)
    for (Vertex& v : mesh.vertices)
      v.uv = {1.7f * v.position.x + 0.4f * v.position.y, 2.3f * v.position.z - 0.3f * v.position.y};
  for (const std::size_t m : {std::size_t{1}, std::size_t{3}}) {
    Material& material = scene.materials[m];
    material.base_color_texture.image = 0;
    material.normal_texture.image = 1;
    material.normal_scale = 0.3f;
    material.transmission_texture.image = 2;
    material.alpha_mode = AlphaMode::Mask;
    material.alpha_cutoff = 0.2f;
  }
  return scene;
}

// A frame of the scene, ready for any device.
struct ReadyFrame {
  explicit ReadyFrame(Scene s = frame_scene()) : scene(std::move(s)) {}
  Scene scene;
  Settings settings = small_settings(96, 96, 75);
  std::unique_ptr<Device> software = make_software_device();
  FrameRenderer renderer{scene, settings, pass_registry(), *software};

  FrameParity against(Device& device) const {
    const SceneOnDevice on_device(scene, renderer.effects(), device);
    return compare_devices(renderer.plan(), pass_registry(), renderer.on_device(), on_device,
                           renderer.inputs());
  }
};

// The software device, but for one value of one attachment of one pass.
class FlawedDevice final : public ForwardingDevice {
 public:
  explicit FlawedDevice(std::string pass) : pass_(std::move(pass)) {}
  PassResult run(const PassRun& run) override {
    PassResult result = ForwardingDevice::run(run);
    if (run.definition->name == pass_) {
      flawed_ = run.colors[0];
      ++result.samples_passed;
    }
    return result;
  }
  Image read_back(TextureId texture) override {
    Image image = ForwardingDevice::read_back(texture);
    if (texture == flawed_) image.at(3, 2, 0) += 1.0f;
    return image;
  }

 private:
  std::string pass_;
  TextureId flawed_ = TextureId::None;
};

// The software device, but that one pass clears its first attachment to other values: what it leaves is wrong
// for whoever reads it.
class WronglyClearingDevice final : public ForwardingDevice {
 public:
  explicit WronglyClearingDevice(std::string pass) : pass_(std::move(pass)) {}
  PassResult run(const PassRun& run) override {
    if (run.definition->name != pass_) return ForwardingDevice::run(run);
    PassDefinition wrong = *run.definition;
    wrong.writes[0].clear = {0.5f, 0.5f, 0.5f, 0.5f};
    PassRun changed = run;
    changed.definition = &wrong;
    return ForwardingDevice::run(changed);
  }

 private:
  std::string pass_;
};

std::size_t differing(const std::vector<AttachmentParity>& attachments) {
  std::size_t count = 0;
  for (const AttachmentParity& a : attachments) count += a.difference.all.differing;
  return count;
}

}  // namespace

TEST_CASE("parity: two software devices agree on every attachment of every pass") {
  ReadyFrame frame;
  const auto scalar = make_software_device({.threads = 1, .lanes = Lanes::Scalar});
  const FrameParity parity = frame.against(*scalar);
  CHECK(parity.counts.size() == frame.renderer.plan().passes.size());
  CHECK(parity.isolated.size() > 50);
  CHECK(parity.whole_frame.size() > 50);
  CHECK(differing(parity.isolated) == 0);
  CHECK(differing(parity.whole_frame) == 0);
  for (const PassCounts& counts : parity.counts) CHECK(counts.equal());
  // Of what several passes draw into, the whole frame has the last state alone.
  std::set<std::string> textures;
  for (const AttachmentParity& a : parity.whole_frame) CHECK(textures.insert(a.attachment).second);
}

TEST_CASE("parity: one wrong value is found, in its pass alone, and with it a wrong count") {
  ReadyFrame frame;
  FlawedDevice flawed("caster_map");
  const FrameParity parity = frame.against(flawed);
  // The pass runs for all three lights; what it read before and what later passes draw is the
  // reference's.
  CHECK(differing(parity.isolated) == 3);
  for (const AttachmentParity& a : parity.isolated) {
    if (a.difference.all.differing == 0) continue;
    CHECK(a.attachment.rfind("caster_position", 0) == 0);
    CHECK(a.difference.differing_texels == 1);
    REQUIRE(a.difference.all.first);
    CHECK(a.difference.all.first->x == 3);
    CHECK(a.difference.all.first->y == 2);
  }
  std::size_t miscounted = 0;
  for (const PassCounts& counts : parity.counts) miscounted += counts.equal() ? 0 : 1;
  CHECK(miscounted == 3);
}

TEST_CASE("parity: what one pass draws wrongly is not held against those that read it") {
  ReadyFrame frame;
  WronglyClearingDevice flawed("caster_map");
  const FrameParity parity = frame.against(flawed);
  CHECK(differing(parity.isolated) > 0);
  for (const AttachmentParity& a : parity.isolated)
    if (a.attachment.rfind("caster_position", 0) != 0) CHECK(a.difference.all.differing == 0);
  // Alone, the device goes on from its own casters, and the picture shows it.
  CHECK(differing(parity.whole_frame) > differing(parity.isolated));
}

TEST_CASE("parity: two software devices agree on casters with textures") {
  ReadyFrame frame(textured_scene());
  const auto scalar = make_software_device({.threads = 1, .lanes = Lanes::Scalar});
  const FrameParity parity = frame.against(*scalar);
  const auto tinted = [](const AttachmentParity& a) { return a.attachment.rfind("caster_tint", 0) == 0; };
  // Of three lights and the camera.
  CHECK(std::count_if(parity.isolated.begin(), parity.isolated.end(), tinted) == 4);
  CHECK(differing(parity.isolated) == 0);
  CHECK(differing(parity.whole_frame) == 0);
}

namespace {

// Every pass of the frame and the frame as a whole, beyond what is allowed for this driver.
void check_against_gl(const ReadyFrame& ready, Device& gl, const std::string& driver) {
  const FrameParity parity = ready.against(gl);
  AllowanceBook book(driver, parity_allowances());
  std::size_t beyond = 0;
  std::string first;
  for (const auto* list : {&parity.isolated, &parity.whole_frame})
    for (const AttachmentParity& a : *list) {
      const bool isolated = list == &parity.isolated;
      const std::string pass = isolated ? a.pass.substr(0, a.pass.find('[')) : "whole frame";
      const std::string attachment = a.attachment.substr(0, a.attachment.find('['));
      if (a.difference.all.differing == 0 || book.covers(pass, attachment, a.difference)) continue;
      beyond += a.difference.all.differing;
      if (first.empty()) first = a.pass + " " + a.attachment;
    }
  if (!is_measured_driver(driver)) {
    WARN("not measured: " << driver << ": " << beyond << " values differ, first in " << first);
    return;
  }
  INFO(driver << ": " << beyond << " values differ, first in " << first);
  CHECK(beyond == 0);
  for (const PassCounts& counts : parity.counts) CHECK(counts.equal());
}

}  // namespace

TEST_CASE("parity: OpenGL draws every pass and the whole frame as the software device does") {
  const auto gl = gl_or_skip();
  const std::string driver = gl_driver_name(gl->renderer(), gl->version());
  check_against_gl(ReadyFrame(), *gl, driver);
  check_against_gl(ReadyFrame(textured_scene()), *gl, driver);
}

TEST_CASE("parity: a frame loop on OpenGL makes nothing after its first frame and reads nothing back") {
  const auto gl = gl_or_skip();
  ReadyFrame frame;
  const SceneOnDevice on_gl(frame.scene, frame.renderer.effects(), *gl);
  const FrameTargets targets(frame.renderer.plan(), *gl);
  const auto draw = [&] {
    run_plan(frame.renderer.plan(), pass_registry(), on_gl, targets, frame.renderer.inputs());
  };
  draw();
  const DeviceObjects first = gl->made();
  CHECK(first.programs > 10);
  CHECK(first.read_backs == 0);
  for (int i = 0; i < 3; ++i) draw();
  CHECK(gl->made() == first);
}
