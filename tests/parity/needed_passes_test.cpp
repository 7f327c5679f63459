// Only what the wanted images depend on is planned, and they are the same as those of a whole frame.
#include <algorithm>

#include "passes/registry.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/renderer/frame_renderer.hpp"
#include "raster/software_device.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/run_pass.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A glass ball over a floor, which a box shadows in part, seen from above.
Scene shadowed_sphere() {
  Scene scene = sphere_scene(1.5f, 4);
  scene.cameras = {camera_down(2.0, 1.0)};
  scene.meshes.push_back(box({-1.4, 0.4, -0.9}, {-0.6, 0.6, -0.4}, 0));
  return scene;
}

std::vector<std::string> labels_of(const Rendering& r) {
  std::vector<std::string> labels;
  for (const PassReport& report : r.passes) labels.push_back(report.label);
  std::sort(labels.begin(), labels.end());
  return labels;
}

// Nothing but their colour tells how light shows on surfaces.
Settings without_highlights() {
  Settings settings = small_settings(32, 32, 24);
  settings.highlights = false;
  return settings;
}

std::vector<std::string> passes_towards(const std::vector<std::string>& textures,
                                        const Scene& scene = shadowed_sphere()) {
  return labels_of(render(scene, small_settings(32, 32, 24), textures));
}

// A ball 25 m beside what the camera sees of the floor: none of its light, not even the little that it throws
// far, gets there.
Scene sphere_out_of_view() {
  Scene scene = sphere_scene(1.5f, 4);
  scene.meshes[0] = floor(40.0, 0.0, 0);
  scene.cameras[0].position.x = 25.0;
  return scene;
}

// Two veils that lie nowhere one behind the other as the camera sees them.
Scene veiled_floor() {
  Scene scene = without_casters(shadowed_sphere());
  scene.materials.push_back(diffuse(0.5f));
  scene.materials.back().alpha_mode = AlphaMode::Blend;
  scene.materials.back().base_color.a = 0.5f;
  for (const double x : {-0.6, 0.5}) {
    Mesh veil = floor(0.3, 1.0 + x, static_cast<int>(scene.materials.size()) - 1);
    for (Vertex& v : veil.vertices) v.position.x += static_cast<float>(x);
    scene.meshes.push_back(veil);
  }
  return scene;
}

// Under a roof that is far wider than the ball.
Scene roofed_sphere() {
  Scene scene = sphere_scene(1.5f, 4);
  scene.meshes.push_back(box({-1.5, 2.0, -1.5}, {1.5, 2.1, 1.5}, 0));
  return scene;
}

Rendering picture_of(const Scene& scene) { return render(scene, small_settings(32, 32, 24), {"picture"}); }

bool runs(const std::vector<std::string>& labels, const std::string& pass) {
  return std::any_of(labels.begin(), labels.end(),
                     [&](const std::string& label) { return label.rfind(pass, 0) == 0; });
}

}  // namespace

TEST_CASE("needed passes: depth, normals and coverage need no light") {
  const std::vector<std::string> expected = {"caster_map.camera", "first_hit", "view_surfaces"};
  CHECK(passes_towards({"aov_normal"}) == expected);
  CHECK(passes_towards({"aov_position"}) == expected);
}

TEST_CASE("needed passes: direct light needs shadows, but no landings") {
  const std::vector<std::string> labels = passes_towards({"aov_direct"});
  CHECK(runs(labels, "shadow_map"));
  CHECK(runs(labels, "caster_map["));
  CHECK(runs(labels, "light_shading["));
  for (const char* pass :
       {"receiver_map", "landing", "enter", "cells", "caustic_", "cascade_", "compose", "glass", "tone_map"})
    CHECK_FALSE(runs(labels, pass));
}

TEST_CASE("needed passes: what is left out changes no texel of what is wanted") {
  const Settings settings = small_settings(32, 32, 24);
  const std::vector<std::string> layers = {"aov_direct", "aov_caustic", "aov_position", "aov_normal"};
  const Rendering whole = render(shadowed_sphere(), settings, layers);
  for (const std::string& layer : layers) {
    INFO(layer);
    CHECK((render(shadowed_sphere(), settings, {layer})[layer].values == whole[layer].values));
  }
}

TEST_CASE("needed passes: casters whose light, shade and shape are out of view are left out of the picture") {
  const Rendering r = picture_of(sphere_out_of_view());
  const std::vector<std::string> expected = {"compose", "light_shading[sun]", "tone_map", "view_surfaces"};
  CHECK(labels_of(r) == expected);
  CHECK(r["picture"].values == picture_of(without_casters(sphere_out_of_view()))["picture"].values);
}

TEST_CASE("needed passes: light that glass in view could show is not out of view") {
  Scene scene = sphere_out_of_view();
  scene.meshes.push_back(sphere({25.0, 0.1, 0.0}, 0.05, 2, 1));
  CHECK(runs(labels_of(picture_of(scene)), "glass"));
}

TEST_CASE("needed passes: black surfaces need no light, but its layers do") {
  Scene scene = sphere_scene(1.5f, 4);
  scene.materials[0].base_color = {0.0f, 0.0f, 0.0f, 1.0f};
  for (const char* pass : {"caster_map[", "walk[", "caustic_cells", "light_shading"}) {
    CHECK_FALSE(runs(labels_of(render(scene, without_highlights(), {"picture"})), pass));
    CHECK(runs(passes_towards({"aov_caustic"}, scene), pass));
  }
  CHECK(runs(passes_towards({"picture"}, scene), "light_shading"));  // for their highlights
}

TEST_CASE("needed passes: what a wanted picture does not depend on says whose reason that is") {
  Scene scene = sphere_scene(1.5f, 4);
  scene.materials[0].base_color = {0.0f, 0.0f, 0.0f, 1.0f};
  const auto device = make_software_device();
  const PlannedFrame frame = plan_frame(scene, without_highlights(), pass_registry(), *device, {{"picture"}});
  REQUIRE_FALSE(frame.effects.reflecting_receivers.active);
  std::size_t found = 0;
  for (const SkippedPass& skipped : frame.plan.skipped)
    for (const char* pass : {"caster_map[", "receiver_map[", "walk[", "caustic_cells[", "light_shading["})
      if (skipped.name.rfind(pass, 0) == 0) {
        CHECK(skipped.reason == frame.effects.reflecting_receivers.reason);
        ++found;
      }
  CHECK(found >= 4);
}

TEST_CASE("needed passes: a spot light turned away from all that is in view is not simulated") {
  Scene scene = shadowed_sphere();
  scene.lights[0].type = LightType::Spot;
  scene.lights[0].position = {0.0, 3.0, 0.0};
  scene.lights[0].inner_cone = 0.2f;
  scene.lights[0].outer_cone = 0.3f;
  CHECK(runs(passes_towards({"picture"}, scene), "light_shading"));
  scene.lights[0].direction = {0.0, 1.0, 0.0};
  const std::vector<std::string> labels = passes_towards({"picture"}, scene);
  for (const char* pass : {"light_shading", "shadow_map", "caster_map[", "landing"})
    CHECK_FALSE(runs(labels, pass));
}

TEST_CASE("needed passes: what follows a light draws nothing where none of its casters' samples pass") {
  Settings settings = small_settings(32, 32, 24);
  settings.interfaces = Interfaces::Two;
  const Rendering r = render(roofed_sphere(), settings, {"aov_caustic", kLanding});
  for (const PassReport& report : r.passes) {
    const std::string name = report.label.substr(0, report.label.find('['));
    const bool follows =
        runs({"caster_exit_map", "receiver_map", "landing", "cells", "caustic_cells", "caustic_map"}, name) &&
        report.label.find('[') != std::string::npos;
    INFO(report.label);
    CHECK(report.result.left_out == follows);
    if (follows) CHECK(report.result.fragments == 0);
    if (name == "caster_map")
      CHECK((report.result.samples_passed > 0) == (report.label == "caster_map.camera"));
  }
  for (const float value : r["aov_caustic"].values) CHECK((value == 0.0f || value == 1.0f));
  for (const float value : r["landing[0]"].values) CHECK(value == 0.0f);
}

TEST_CASE("needed passes: a layer that nothing lies in is not lit, and none is looked for behind it") {
  const Rendering r = render(veiled_floor(), without_highlights(), {"beauty"});
  std::size_t drawn = 0, left_out = 0;
  for (const PassReport& report : r.passes) {
    const std::size_t at = report.label.find(".layer ");
    if (at == std::string::npos) continue;
    const int layer = report.label[at + 7] - '0';
    const bool looks = report.label.rfind("view_surfaces", 0) == 0;
    const bool composes = report.label.rfind("compose", 0) == 0;
    INFO(report.label);
    CHECK(report.result.left_out == (layer > (looks ? 2 : 1) && !composes));
    if (looks) CHECK((report.result.samples_passed > 0) == (layer == 1));
    (report.result.left_out ? left_out : drawn) += 1;
  }
  CHECK(drawn == 2 + 1 + 4);
  CHECK(left_out == 2 + 3);
  // Half of what lies behind shows through, whatever was composed for further layers.
  CHECK(texel(r["scene_color.layer 4"], 6, 12).w == 0.5f);
  CHECK(texel(r["scene_color.layer 4"], 12, 12) == glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
}

TEST_CASE(
    "needed passes: a frame without casters has no caustic, without a surface that shines no emission") {
  const auto textures_of = [](Scene scene) {
    const auto device = make_software_device({.threads = 1});
    const FrameRenderer renderer(scene, small_settings(16, 16, 16), pass_registry(), *device);
    return std::pair(renderer.has("caustic"), renderer.has("view_emission"));
  };
  Scene scene = shadowed_sphere();
  CHECK(textures_of(scene) == std::pair(true, false));
  scene.materials[0].emissive = glm::vec3(1.0f);
  CHECK(textures_of(without_casters(scene)) == std::pair(false, true));
}

TEST_CASE("needed passes: what is wanted beside the images is kept where it is drawn for them anyway") {
  const auto device = make_software_device({.threads = 1});
  Scene scene = shadowed_sphere();
  const auto renderer_for = [&](const std::string& image) {
    return FrameRenderer(scene, small_settings(16, 16, 16), pass_registry(), *device,
                         {.goal = {.textures = {image}, .beside = {kLandingFresnel}}});
  };
  CHECK(renderer_for("picture").has("landing_fresnel[0]"));
  CHECK_FALSE(renderer_for("aov_direct").has("landing_fresnel[0]"));
}

TEST_CASE("needed passes: light by light, a light's textures can be read until its last pass has run") {
  const auto device = make_software_device({.threads = 1});
  Scene scene = shadowed_sphere();
  scene.lights.push_back(sun({0.3, -1.0, 0.2}, 1.0f));
  FrameRenderer whole(scene, small_settings(16, 16, 16), pass_registry(), *device);
  whole.run();
  FrameRenderer renderer(scene, small_settings(16, 16, 16), pass_registry(), *device,
                         {.goal = {.textures = {"picture", kLanding}, .light_by_light = true}});
  std::size_t ended = 0;
  renderer.run([&](const PlannedPass& pass, const PassResult&, std::size_t, std::size_t) {
    if (!pass.ends_light) return true;
    ++ended;
    const std::string name = light_texture(kLanding, pass.light);
    CHECK(renderer.read(name).values == whole.read(name).values);
    return true;
  });
  CHECK(ended == 2);
  CHECK(renderer.read("picture").values == whole.read("picture").values);
  CHECK_THROWS_AS(renderer.read("landing[0]"), Error);
  CHECK_THROWS_AS(renderer.read("landing[1]"), Error);
}

TEST_CASE("needed passes: a texture that the goal does not name cannot be read") {
  const auto device = make_software_device({.threads = 1});
  Scene scene = shadowed_sphere();
  FrameRenderer renderer(scene, small_settings(16, 16, 16), pass_registry(), *device,
                         {.goal = {{"picture"}}});
  renderer.run();
  CHECK_NOTHROW(renderer.read("picture"));
  CHECK_THROWS_AS(renderer.read("landing[0]"), Error);
}
