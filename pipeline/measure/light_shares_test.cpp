#include "pipeline/measure/light_shares.hpp"

#include <cmath>

#include "pipeline/effects/dim_lights.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Light lamp(const glm::dvec3& position, float candela) {
  Light light;
  light.type = LightType::Point;
  light.position = position;
  light.intensity = candela;
  return light;
}

// A small ball of glass over a floor, and lamps 10 m above it: one of 100 cd, the others of 1 cd each.
Scene lit_by(int dim) {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = {floor(10.0, -1.0, 0), box({-0.01, -0.01, -0.01}, {0.01, 0.01, 0.01}, 1)};
  scene.lights = {lamp({0.0, 10.0, 0.0}, 100.0f)};
  for (int i = 0; i < dim; ++i) scene.lights.push_back(lamp({0.0, 10.0, 0.0}, 1.0f));
  return scene;
}

std::vector<LightShare> shares_in(const Scene& scene, double least) {
  return light_shares(scene, effects_of(scene, {}), least);
}

int left_out(const std::vector<LightShare>& shares) {
  int count = 0;
  for (const LightShare& found : shares) count += found.left_out ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("light shares: few lights are all drawn in full") {
  CHECK(shares_in(lit_by(15), 0.5).empty());
  CHECK(shares_in(lit_by(16), 0.5).size() == 17);
}

TEST_CASE("light shares: a share is that of the light on the caster") {
  const std::vector<LightShare> shares = shares_in(lit_by(20), 0.0);
  CHECK(shares[0].share == Approx(100.0 / 120.0));
  CHECK(shares[7].share == Approx(1.0 / 120.0));
  CHECK(left_out(shares) == 0);
}

TEST_CASE("light shares: samples of one lamp count together, as the lamp that they are of") {
  Scene scene = lit_by(20);
  for (const std::size_t sample : {1u, 2u}) scene.lights[sample].source = 0;
  scene.lights[4].source = 3;
  const std::vector<LightShare> shares = shares_in(scene, 0.0);
  CHECK(shares[0].share == Approx(102.0 / 120.0));
  CHECK(shares[1].share == 0.0);
  CHECK(shares[3].share == Approx(2.0 / 120.0));
  CHECK(shares[4].share == 0.0);
  CHECK(shares[5].share == Approx(1.0 / 120.0));
}

// A lamp gives 1/120 of the light, and at the ball's nearest point a little more: of 5 % six would be
// exactly, so five go.
TEST_CASE("light shares: the weakest are left out as long as all of them give less than asked for") {
  CHECK(left_out(shares_in(lit_by(20), 0.05)) == 5);
  CHECK(left_out(shares_in(lit_by(20), 0.005)) == 0);
}

TEST_CASE("light shares: a Lambertian lamp gives by the cosine, and nothing to its back") {
  Scene scene = lit_by(20);
  Light& lamp = scene.lights[0];
  lamp.lambertian = true;
  lamp.direction = {0.0, -1.0, 0.0};
  CHECK(shares_in(scene, 0.0)[0].share == Approx(100.0 / 120.0));
  // Turned by 60 degrees: half as much. Turned away: nothing.
  lamp.direction = {std::sqrt(0.75), -0.5, 0.0};
  CHECK(shares_in(scene, 0.0)[0].share == Approx(50.0 / 70.0).epsilon(0.01));
  lamp.direction = {0.0, 1.0, 0.0};
  CHECK(shares_in(scene, 0.0)[0].share == 0.0);
}

TEST_CASE("light shares: what a wall hides from the caster outshines nothing") {
  Scene scene = lit_by(20);
  scene.meshes.push_back(box({-5.0, 10.5, -5.0}, {5.0, 10.6, 5.0}, 0));
  scene.lights[0].position = {0.0, 11.0, 0.0};
  const std::vector<LightShare> shares = shares_in(scene, 0.005);
  CHECK(shares[0].share == 0.0);
  CHECK(shares[1].share == Approx(1.0 / 20.0));
}

TEST_CASE("light shares: the only lamp of a caster of its own counts in full, however dim it is") {
  Scene scene = lit_by(20);
  scene.meshes.push_back(box({999.99, -0.01, -0.01}, {1000.01, 0.01, 0.01}, 1));
  scene.lights.push_back(lamp({1000.0, 10.0, 0.0}, 0.1f));
  for (Light& light : scene.lights) light.range = 50.0f;
  const std::vector<LightShare> shares = shares_in(scene, 0.05);
  CHECK(shares.back().share == Approx(1.0));
  CHECK_FALSE(shares.back().left_out);
}

TEST_CASE("dim lights: sides shrink with the root of the share, and what is left out says why") {
  const Scene scene = lit_by(20);
  const Settings settings;
  const Effects effects =
      with_dim_lights(effects_of(scene, settings), scene, settings, shares_in(scene, 0.05));
  CHECK(effects.dim_lights.active);
  // 1/120 * 3^2 is less than 1/8, 1/120 * 4^2 is more.
  const LightSettings own(settings, effects);
  CHECK(own[0].grid == 512);
  CHECK(own[20].grid == 512 / 3);
  CHECK(own[20].map == 512 / 3);
  CHECK(own[20].shadow == 2048 / 3);
  CHECK(own[-1].grid == 512);
  int expected = 0;
  for (const Expectation& e : effects.expectations) expected += e.expected ? 1 : 0;
  CHECK(expected == 16);
  // Their direct light stays.
  for (const LightEffects& light : effects.lights) CHECK(light.lights_nothing.empty());
}

TEST_CASE("dim lights: settings of 0 leave every light as it is") {
  const Scene scene = lit_by(20);
  Settings settings;
  settings.least_light = settings.full_light = 0.0f;
  const Effects effects =
      with_dim_lights(effects_of(scene, settings), scene, settings, shares_in(scene, 0.0));
  CHECK_FALSE(effects.dim_lights.active);
  CHECK(LightSettings(settings, effects)[20].grid == 512);
}
