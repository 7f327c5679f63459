// Whole frames on the software Device and on OpenGL: every texture of every pass.
#include <bit>
#include <cmath>

#include "tests/gl/gl_or_skip.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Glass and diffuse bodies, a box that the view cuts off, an absorbing medium, two kinds of light.
Scene frame_scene() {
  Scene scene = sphere_scene(1.5f, 4);
  scene.materials[1].attenuation_distance = 0.5f;
  scene.materials[1].attenuation_color = {0.9f, 0.5f, 0.3f};
  scene.meshes.push_back(box({-1.4, 0.0, -0.9}, {-0.6, 0.15, -0.4}, 0));
  scene.meshes.push_back(box({0.4, 0.2, 0.3}, {0.9, 0.6, 0.7}, 1));
  scene.lights = {sun({0.3, -1.0, -0.2}, 2.0f)};
  Light point{.name = "point", .type = LightType::Point, .intensity = 3.0f};
  point.position = {-0.8, 2.0, 0.6};
  scene.lights.push_back(point);
  return scene;
}

// How many values differ in their bits; NaN equals NaN.
std::size_t differing(const Image& a, const Image& b) {
  REQUIRE(a.shape == b.shape);
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    if (!(std::isnan(a.values[i]) && std::isnan(b.values[i])) &&
        std::bit_cast<std::uint32_t>(a.values[i]) != std::bit_cast<std::uint32_t>(b.values[i]))
      ++count;
  return count;
}

void expect_same_frame(const Settings& settings) {
  const auto device = gl_or_skip();
  if (!device) return;
  const std::vector<std::string> wanted = {"picture",     "beauty",       "aov_direct",
                                           "aov_caustic", "aov_position", "aov_normal"};
  const Scene scene = frame_scene();
  const Rendering software = render(scene, settings, wanted);
  const Rendering gl = render_on(*device, scene, settings, wanted);
  REQUIRE(software.images.size() > 20);
  REQUIRE(software.images.size() == gl.images.size());
  for (const auto& [name, image] : software.images) {
    const std::size_t count = differing(image, gl[name]);
    INFO(name << ": " << count << " of " << image.values.size() << " values differ");
    if (is_llvmpipe(*device))
      CHECK(count == 0);
    else if (count > 0)
      WARN(name << ": " << count << " of " << image.values.size() << " values differ on "
                << device->description());
  }
  for (std::size_t i = 0; is_llvmpipe(*device) && i < software.passes.size(); ++i) {
    INFO(software.passes[i].label);
    CHECK(software.passes[i].result.samples_passed == gl.passes[i].result.samples_passed);
    CHECK(software.passes[i].result.primitives == gl.passes[i].result.primitives);
  }
}

}  // namespace

TEST_CASE("parity: every texture of a frame") {
  Settings settings = small_settings(96, 96, 75);
  settings.height = 51;
  expect_same_frame(settings);
}

TEST_CASE("parity: every texture of a frame at powers of two") {
  expect_same_frame(small_settings(128, 128, 64));
}
