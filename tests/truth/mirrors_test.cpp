// Mirrors that send a light's rays where it does not look.
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/run_pass.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A lamp 1 m above the floor shines up, at a mirror 2 m above it that sends the light back past the lamp.
Scene lamp_under_mirror() {
  Scene scene;
  scene.materials = {diffuse(0.8f), metal({1.0f, 1.0f, 1.0f})};
  scene.meshes = {floor(3.0, 0.0, 0), box({-0.5, 2.0, -0.5}, {0.5, 2.1, 0.5}, 1)};
  Light light{.name = "lamp", .type = LightType::Spot, .intensity = 90.0f};
  light.position = {0.0, 1.0, 0.0};
  light.direction = {0.0, 1.0, 0.0};
  light.inner_cone = 0.3f;
  light.outer_cone = 0.31f;
  scene.lights = {light};
  scene.cameras = {camera_down(0.2, 0.6)};
  return scene;
}

}  // namespace

TEST_CASE("mirrors: what a mirror sends back past the lamp lights what lies behind the lamp") {
  const Rendering r = render(lamp_under_mirror(), small_settings(128, 128, 32),
                             {"aov_caustic", "aov_direct", "aov_position"});
  // As if the lamp stood 3 m above the floor, for 1 m of the way up and two down: I cos / d^2.
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const glm::vec4 p = texel(r["aov_position"], x, y);
      const double squared = 9.0 + static_cast<double>(p.x) * static_cast<double>(p.x) +
                             static_cast<double>(p.z) * static_cast<double>(p.z);
      CHECK(static_cast<double>(r["aov_caustic"].at(x, y, 0)) ==
            Approx(90.0 * 3.0 / (squared * std::sqrt(squared))).epsilon(5e-3));
      CHECK(r["aov_direct"].at(x, y, 0) == 0.0f);
    }
}
