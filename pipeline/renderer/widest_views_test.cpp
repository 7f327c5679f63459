#include "pipeline/renderer/widest_views.hpp"

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pilot.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("widest views: each side of a panel between two balls looks at the ball before it") {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = {floor(3.0, 0.0, 0), sphere({-1.2, 0.7, 0.0}, 0.4, 2, 1),
                  sphere({1.2, 0.7, 0.0}, 0.4, 2, 1)};
  for (const double side : {-1.0, 1.0}) {
    Light lamp{.name = "side", .type = LightType::Point, .intensity = 1.0f};
    // The balls' middle lies in the panel's plane, but for rounding.
    lamp.position = {side * 1e-9, 1.2, 0.1};
    lamp.direction = {side, 0.0, 0.0};
    lamp.lambertian = true;
    scene.lights.push_back(lamp);
  }
  const Settings settings;
  const Effects effects = effects_of(scene, settings);
  for (int l = 0; l < 2; ++l) {
    const View view = widest_views(scene, effects, settings, l).caster;
    const Light& lamp = scene.lights[static_cast<std::size_t>(l)];
    const glm::dvec3 ball = glm::dvec3(lamp.direction.x * 1.2, 0.7, 0.0);
    CHECK(glm::dot(view.forward, glm::normalize(ball - lamp.position)) > 0.999);
  }
}
