// Light through surfaces that take, scatter, cover or mirror a share of it.
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/run_pass.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr double kPi = 3.14159265358979;
// A pane, or a slab, under 100 lux: (1 - R) / (1 + R) with R = 0.04 in all orders.
constexpr double kThrough = 0.96 / 1.04;

double mean_of(const Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) sum += image.at(x, y, 1);
  return sum / (image.width() * image.height());
}

// Lux in the middle of a floor, under a square of 2 m of this material half a metre up; slab: 0.1 m thick.
double lux_under(const Material& material, bool slab) {
  Scene scene;
  scene.materials = {diffuse(0.8f), material};
  scene.meshes = {floor(3.0, 0.0, 0), slab ? box({-1, 0.5, -1}, {1, 0.6, 1}, 1) : floor(1.0, 0.5, 1)};
  scene.lights = {sun({0.0, -1.0, 0.0}, 100.0f)};
  scene.cameras = {camera_down(0.4, 0.4)};
  const Rendering r = render(scene, small_settings(64, 64, 16), {"aov_direct", "aov_caustic"});
  return mean_of(r["aov_direct"]) + mean_of(r["aov_caustic"]);
}

Material pane(float transmission) {
  Material m = glass(1.5f);
  m.thickness = 0.0f;
  m.transmission = transmission;
  return m;
}

// Lux under a slab of clear glass with a pane at this height: above it, 0.6 m, or below, 0.5. The pane's
// picture, if it has one, is white of this alpha.
glm::dvec3 lux_under_slab_and(const Material& other, double height, float further_share = 0.03f,
                              float alpha_of_picture = 1.0f) {
  Scene scene;
  scene.images = {filled(1, 1, {1.0f, 1.0f, 1.0f, alpha_of_picture})};
  scene.materials = {diffuse(0.8f), glass(1.5f), other};
  scene.meshes = {floor(3.0, 0.0, 0), box({-1, 0.5, -1}, {1, 0.6, 1}, 1), floor(1.5, height, 2)};
  scene.lights = {sun({0.0, -1.0, 0.0}, 100.0f)};
  scene.cameras = {camera_down(0.4, 0.2)};  // below all of them
  Settings settings = small_settings(64, 64, 16);
  settings.further_share = further_share;
  const Rendering r = render(scene, settings, {"aov_direct", "aov_caustic"});
  const Image& caustic = r["aov_caustic"];
  CHECK(mean_of(r["aov_direct"]) < 1e-4);
  return {caustic.at(8, 8, 0), caustic.at(8, 8, 1), caustic.at(8, 8, 2)};
}

}  // namespace

TEST_CASE("shares: a slab and a pane let through what their transmission says, once") {
  Material slab = glass(1.5f);
  slab.transmission = 0.6f;
  CHECK(lux_under(slab, true) == Approx(60.0 * kThrough).epsilon(0.003));
  CHECK(lux_under(pane(0.4f), false) == Approx(40.0 * kThrough).epsilon(0.003));
  CHECK(lux_under(pane(1.0f), false) == Approx(100.0 * kThrough).epsilon(0.003));
}

TEST_CASE("shares: where a pane's alpha says that it is not, all light passes") {
  Material m = pane(0.76f);
  m.alpha_mode = AlphaMode::Blend;
  m.base_color = {0.0f, 0.0f, 0.0f, 0.25f};
  CHECK(lux_under(m, false) == Approx(75.0).epsilon(1e-3));
}

TEST_CASE("shares: a pane tints a caustic, before its caster and behind it") {
  Material m = pane(1.0f);
  m.base_color = {1.0f, 0.5f, 0.0f, 1.0f};
  const glm::dvec3 before = lux_under_slab_and(m, 0.8), behind = lux_under_slab_and(m, 0.45);
  const double both = 100.0 * kThrough * kThrough;
  CHECK(before.x == Approx(both).epsilon(0.003));
  CHECK(before.y == Approx(0.5 * both).epsilon(0.003));
  CHECK(before.z == 0.0);
  // Behind it what goes to and fro between slab and pane counts too.
  const double mirrored = 1.0 - kThrough, all = both / (1.0 - mirrored * mirrored);
  CHECK(behind.x == Approx(all).epsilon(0.004));
  CHECK(behind.y == Approx(0.5 * all).epsilon(0.004));
  CHECK(behind.z == 0.0);
}

TEST_CASE("shares: a pane tints light that is followed, before its caster") {
  Material m = pane(1.0f);
  m.base_color = {1.0f, 0.5f, 0.0f, 1.0f};
  const glm::dvec3 light = lux_under_slab_and(m, 0.8, 0.0f);
  const double mirrored = 1.0 - kThrough, all = 100.0 * kThrough * kThrough / (1.0 - mirrored * mirrored);
  // Which vertices send on what goes to and fro is drawn.
  CHECK(light.x == Approx(all).epsilon(0.01));
  CHECK(light.y == Approx(0.5 * all).epsilon(0.01));
  CHECK(light.z == 0.0);
}

TEST_CASE("shares: what an alpha mask leaves of a receiver keeps followed light, its holes let it through") {
  Material m = diffuse(0.5f);
  m.alpha_mode = AlphaMode::Mask;
  m.alpha_cutoff = 0.5f;
  m.base_color.a = 0.4f;
  CHECK(lux_under_slab_and(m, 0.45, 0.0f).y == Approx(100.0 * kThrough).epsilon(0.003));
  m.base_color.a = 0.6f;
  CHECK(lux_under_slab_and(m, 0.45, 0.0f).y == 0.0);
}

TEST_CASE("shares: of a caustic behind a pane its alpha leaves what is not covered") {
  Material m = pane(1.0f);
  m.alpha_mode = AlphaMode::Blend;
  m.base_color = {0.0f, 0.0f, 0.0f, 0.25f};
  CHECK(lux_under_slab_and(m, 0.8).y == Approx(75.0 * kThrough).epsilon(0.003));
  CHECK(lux_under_slab_and(m, 0.45).y == Approx(75.0 * kThrough).epsilon(0.004));
}

TEST_CASE("shares: a picture's alpha says how much of a pane is there") {
  Material m = pane(1.0f);
  m.alpha_mode = AlphaMode::Blend;
  m.base_color = {0.0f, 0.0f, 0.0f, 0.5f};
  m.base_color_texture.image = 0;
  m.least_alpha = m.most_alpha = 0.5f;
  CHECK(lux_under_slab_and(m, 0.8, 0.03f, 0.5f).y == Approx(75.0 * kThrough).epsilon(0.003));
  CHECK(lux_under_slab_and(m, 0.45, 0.03f, 0.5f).y == Approx(75.0 * kThrough).epsilon(0.004));
}

TEST_CASE("shares: followed light passes what is a layer of a blended receiver, and lands on the rest") {
  Material m = diffuse(0.5f);
  m.alpha_mode = AlphaMode::Blend;
  m.base_color_texture.image = 0;
  m.least_alpha = 0.0f;
  m.most_alpha = 1.0f;
  CHECK(lux_under_slab_and(m, 0.45, 0.0f, 0.4f).y == Approx(100.0 * kThrough).epsilon(0.003));
  CHECK(lux_under_slab_and(m, 0.45, 0.0f, 1.0f).y == 0.0);
}

TEST_CASE("shares: without its specular share a slab takes nothing") {
  Material slab = glass(1.5f);
  slab.fresnel_factor = 0.0f;
  CHECK(lux_under(slab, true) == Approx(100.0).epsilon(0.003));
}

TEST_CASE("shares: level water lights the wall behind it by Fresnel's share") {
  // A sun 70 degrees from the vertical: 100 sin 70 = 93.97 lux on the wall. Water of index 1.33 mirrors there
  // R: cos i = 0.342020, cos t = 0.707687; rs = ((0.342020 - 0.941224) / 1.283244)^2 = 0.218035, rp =
  // ((0.707687 - 0.454887) / 1.162574)^2 = 0.047284, R = 0.132660: 12.47 lux more.
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.33f)};
  Mesh wall = floor(2.0, 0.0, 0);
  for (Vertex& v : wall.vertices) {
    v.position = {2.0f, v.position.x + 2.0f, v.position.z};
    v.normal = {-1.0f, 0.0f, 0.0f};
  }
  finish(wall, 0.0f);
  scene.meshes = {floor(6.0, -1.0, 0), floor(2.0, 0.0, 1), wall};
  scene.lights = {sun({std::sin(70.0 * kPi / 180.0), -std::cos(70.0 * kPi / 180.0), 0.0}, 100.0f)};
  Camera camera{.name = "wall", .orthographic = true};
  camera.position = {1.0, 0.5, 0.0};
  camera.right = {0.0, 0.0, 1.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.forward = {1.0, 0.0, 0.0};
  camera.half_width = camera.half_height = 0.2;
  camera.near = 1e-3;
  camera.far = 100.0;
  scene.cameras = {camera};
  const Rendering r = render(scene, small_settings(128, 128, 16), {"aov_direct", "aov_caustic"});
  CHECK(mean_of(r["aov_direct"]) == Approx(93.97).epsilon(1e-3));
  CHECK(mean_of(r["aov_caustic"]) == Approx(12.47).epsilon(0.005));
}

TEST_CASE("shares: an opaque thing in glass takes its light") {
  // A box over the whole lower half of a slab's middle, 0.8 m wide: under it nothing but what goes round.
  const auto lux = [](bool with_thing) {
    Scene scene;
    scene.materials = {diffuse(0.8f), glass(1.5f)};
    scene.meshes = {floor(3.0, 0.0, 0), box({-1, 0.5, -1}, {1, 0.9, 1}, 1)};
    if (with_thing) scene.meshes.push_back(box({-0.4, 0.6, -0.4}, {0.4, 0.8, 0.4}, 0));
    scene.lights = {sun({0.0, -1.0, 0.0}, 100.0f)};
    scene.cameras = {camera_down(0.4, 0.3)};
    const Rendering r = render(scene, small_settings(64, 64, 16), {"aov_direct", "aov_caustic"});
    return mean_of(r["aov_direct"]) + mean_of(r["aov_caustic"]);
  };
  CHECK(lux(false) == Approx(100.0 * kThrough).epsilon(0.003));
  CHECK(lux(true) < 0.5);
}
