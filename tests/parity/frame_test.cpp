// Whole frames: the comparison itself on two software devices, then software against OpenGL.
#include <algorithm>
#include <map>
#include <set>

#include "passes/registry.hpp"
#include "pipeline/renderer/frame_renderer.hpp"
#include "pipeline/renderer/parity_judgement.hpp"
#include "pipeline/scene/mip_levels.hpp"
#include "tests/parity/match.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/forwarding_device.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Glass and diffuse bodies, a box that the view cuts off, a thin pane, a mirror, blended boxes, an absorbing
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
  Material veil = diffuse(0.5f);
  veil.base_color.a = 0.4f;
  veil.alpha_mode = AlphaMode::Blend;
  scene.materials.push_back(veil);
  scene.meshes.push_back(box({-0.4, 0.1, 0.55}, {0.2, 0.5, 0.8}, 4));
  scene.meshes.push_back(box({-0.3, 1.4, -0.3}, {0.1, 1.5, 0.3}, 4));
  scene.lights = {sun({0.3, -1.0, -0.2}, 2.0f)};
  Light point{.name = "point", .type = LightType::Point, .intensity = 3.0f};
  point.position = {-0.8, 2.0, 0.6};
  scene.lights.push_back(point);
  Light panel = point;
  panel.position = {0.9, 1.5, -0.8};
  panel.direction = glm::normalize(glm::dvec3(-0.5, -1.0, 0.6));
  panel.lambertian = true;
  scene.lights.push_back(panel);
  scene.environment.reach = 1.0f;
  return scene;
}

// The same with textures of every kind, holes in glass and metal included.
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
    material.base_color_texture.wrap_u = material.normal_texture.wrap_v = Wrap::Mirror;
    material.transmission_texture.wrap_u = Wrap::Clamp;
    material.alpha_mode = AlphaMode::Mask;
    material.alpha_cutoff = 0.2f;
  }
  Material& receiver = scene.materials[0];
  receiver.emissive = glm::vec3(0.1f);
  receiver.base_color_texture.image = receiver.emissive_texture.image =
      receiver.metallic_roughness_texture.image = receiver.occlusion_texture.image = 0;
  receiver.normal_texture.image = 1;
  receiver.occlusion_strength = 0.7f;
  receiver.normal_texture.wrap_u = receiver.emissive_texture.wrap_v = Wrap::Clamp;
  receiver.base_color_texture.wrap_v = Wrap::Mirror;
  receiver.base_color_texture.nearest = true;
  Material& veil = scene.materials[4];  // some of it opaque
  veil.base_color_texture.image = 0;
  veil.base_color.a = 1.0f;
  veil.least_alpha = 0.0f;
  add_mip_levels(scene);
  return scene;
}

// A frame of the scene, ready for any device.
struct ReadyFrame {
  static Settings two_surfaces() {
    Settings settings = small_settings(96, 96, 75);
    settings.interfaces = Interfaces::Two;
    return settings;
  }
  explicit ReadyFrame(Scene s = frame_scene(), const Settings& with = two_surfaces())
      : scene(std::move(s)), settings(with) {}
  Scene scene;
  Settings settings;
  std::unique_ptr<Device> software = make_software_device();
  FrameRenderer renderer{scene, settings, pass_registry(), *software};

  FrameParity against(Device& device) const {
    const SceneOnDevice on_device(scene, renderer.effects(), device);
    return compare_devices(renderer.plan(), pass_registry(), renderer.on_device(), on_device,
                           renderer.inputs());
  }
  JudgedFrame judged(Device& device, DriverClass driver) const {
    return judge(against(device), renderer.plan(), pass_registry(), driver);
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
  // Of what several passes draw into, the whole frame has the last state alone.
  std::set<std::string> textures;
  for (const AttachmentParity& a : parity.whole_frame) CHECK(textures.insert(a.attachment).second);
  CHECK(frame.judged(*scalar, DriverClass::LlvmpipeFused).passes());
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
  const JudgedFrame judged = frame.judged(flawed, DriverClass::LlvmpipeFused);
  CHECK(std::count_if(judged.counts.begin(), judged.counts.end(),
                      [](const JudgedCounts& c) { return !c.agree; }) == 3);
  CHECK_FALSE(judged.passes());
}

TEST_CASE("parity: a comparison that is told to stop after a pass runs no further one") {
  ReadyFrame frame(sphere_scene(1.5f, 1));
  const SceneOnDevice tested(frame.scene, frame.renderer.effects(), *frame.software);
  std::size_t told = 0;
  const auto compare = [&] {
    compare_devices(
        frame.renderer.plan(), pass_registry(), frame.renderer.on_device(), tested, frame.renderer.inputs(),
        {}, [&](const PlannedPass&, const PassResult&, std::size_t, std::size_t) { return ++told < 3; });
  };
  CHECK_THROWS_AS(compare(), Error);
  CHECK(told == 3);
}

TEST_CASE("parity: a pass, an attachment or a texture of the frame that was not compared fails") {
  ReadyFrame frame;
  const FrameParity whole = frame.against(*make_software_device());
  const auto missing = [&](const FrameParity& parity) {
    const JudgedFrame judged = judge(parity, frame.renderer.plan(), pass_registry(), DriverClass::Hardware);
    CHECK(judged.passes() == judged.missing.empty());
    return judged.missing;
  };
  CHECK(missing(whole).empty());
  FrameParity part = whole;
  part.counts.erase(part.counts.begin());
  CHECK(missing(part) == std::vector<std::string>{whole.counts.front().pass + " counts"});
  part = whole;
  part.isolated.pop_back();
  CHECK(missing(part) ==
        std::vector<std::string>{whole.isolated.back().pass + " " + whole.isolated.back().attachment});
  part = whole;
  part.whole_frame.pop_back();
  CHECK(missing(part) == std::vector<std::string>{"whole frame " + whole.whole_frame.back().attachment});
}

TEST_CASE("parity: what an attachment holds follows from the pass that draws it") {
  ReadyFrame frame;
  const FrameParity parity = frame.against(*make_software_device());
  std::map<std::string, ImageKind> kinds, in_frame;
  const JudgedFrame judged =
      judge(parity, frame.renderer.plan(), pass_registry(), DriverClass::LlvmpipeFused);
  for (const JudgedAttachment& a : judged.isolated) kinds[a.parity.pass + " " + a.parity.attachment] = a.kind;
  for (const JudgedAttachment& a : judged.whole_frame) in_frame[a.parity.attachment] = a.kind;
  CHECK(kinds.at("landing[sun] landing_flux[0]") == ImageKind::Shading);
  CHECK(kinds.at("view_surfaces view_position") == ImageKind::RasterizedMap);
  CHECK(kinds.at("caster_map[sun] caster_depth[0]") == ImageKind::RasterizedMap);
  CHECK(kinds.at("caustic_map[sun] caustic_map[0]") == ImageKind::FluxMap);
  CHECK(kinds.at("light_shading[sun] direct") == ImageKind::Shading);
  CHECK(kinds.at("tone_map picture") == ImageKind::Picture);
  CHECK(in_frame.at("picture") == ImageKind::Picture);
  CHECK(in_frame.at("beauty") == ImageKind::Beauty);
  CHECK(in_frame.at("caustic_map[0]") == ImageKind::Intermediate);
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
  // Of three lights, and of the camera with panes and without.
  CHECK(std::count_if(parity.isolated.begin(), parity.isolated.end(), tinted) == 5);
  CHECK(differing(parity.isolated) == 0);
  CHECK(differing(parity.whole_frame) == 0);
}

namespace {

// Every pass of the frame and the frame as a whole.
void check_against_gl(const ReadyFrame& ready, GlDevice& gl) {
  const JudgedFrame judged = ready.judged(gl, driver_class(gl));
  INFO(name_of(judged.driver) << ": " << judged.differing_values() << " values differ");
  for (const auto* list : {&judged.isolated, &judged.whole_frame})
    for (const JudgedAttachment& a : *list) {
      INFO(a.parity.pass << " " << a.parity.attachment << ": " << a.verdict.reason);
      CHECK(a.verdict.verdict != Verdict::Beyond);
    }
  for (const JudgedCounts& counts : judged.counts) {
    INFO(counts.counts.pass);
    CHECK(counts.agree);
  }
  CHECK(judged.missing.empty());
}

}  // namespace

TEST_CASE("parity: OpenGL draws every pass and the whole frame as the software device does") {
  const auto gl = gl_or_skip();
  check_against_gl(ReadyFrame(), *gl);
  check_against_gl(ReadyFrame(textured_scene()), *gl);
}

TEST_CASE("parity: OpenGL draws 4 samples a pixel as the software device does") {
  const auto gl = gl_or_skip();
  Settings settings = small_settings(48, 48, 40);
  settings.samples = 4;
  const ReadyFrame frame(frame_scene(), settings);
  REQUIRE(frame.renderer.has("beauty.sample 4"));
  check_against_gl(frame, *gl);
}

TEST_CASE("parity: OpenGL follows light from surface to surface as the software device does") {
  const auto gl = gl_or_skip();
  Settings settings = small_settings(48, 48, 40);
  settings.further_share = 0.0f;
  settings.bounces = 6;
  Scene scene = frame_scene();
  scene.materials[1].dispersion = 0.5f;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) scene.meshes[i].object = static_cast<int>(i);
  scene.lights.resize(1);
  const ReadyFrame frame(scene, settings);
  REQUIRE(frame.renderer.effects().further_surfaces.active);
  check_against_gl(frame, *gl);
}

TEST_CASE("parity: OpenGL draws whole frames where its points are small and become quadrilaterals") {
  const auto gl = gl_or_skip({.measure = true, .debug = true, .largest_point = 2.0f});
  check_against_gl(ReadyFrame(), *gl);
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
