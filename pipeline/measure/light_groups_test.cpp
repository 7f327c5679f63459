#include "pipeline/measure/light_groups.hpp"

#include "pipeline/effects/dim_lights.hpp"
#include "pipeline/measure/light_shares.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Light lamp(const glm::dvec3& position, float candela, const glm::vec3& color = glm::vec3(1.0f)) {
  Light light;
  light.type = LightType::Point;
  light.position = position;
  light.intensity = candela;
  light.color = color;
  return light;
}

// A box of glass over a floor, and so many lamps: half of them near (-10, 10, 0), half near (10, 10, 0).
Scene two_clusters(int lamps, double apart = 0.1) {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = {floor(10.0, -1.0, 0), box({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}, 1)};
  for (int i = 0; i < lamps; ++i)
    scene.lights.push_back(
        lamp({(i % 2 == 0 ? -10.0 : 10.0) + apart * (i / 2), 10.0, 0.0}, 1.0f + static_cast<float>(i)));
  return scene;
}

std::vector<LightShare> grouped_in(const Scene& scene, int most) {
  const Effects effects = effects_of(scene, {});
  std::vector<LightShare> shares = light_shares(scene, effects, 0.0);
  group_lights(scene, effects, most, shares);
  return shares;
}

int alone(const std::vector<LightShare>& shares) {
  int count = 0;
  for (const LightShare& found : shares) count += found.drawn_with < 0 ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("light groups: so many lights are drawn on their own as are asked for") {
  const Scene scene = two_clusters(40);
  CHECK(alone(grouped_in(scene, 0)) == 40);
  CHECK(alone(grouped_in(scene, 40)) == 40);
  CHECK(alone(grouped_in(scene, 7)) == 7);
}

TEST_CASE("light groups: a light's caustic is drawn by one near it, which is drawn on its own") {
  const std::vector<LightShare> shares = grouped_in(two_clusters(40), 2);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (shares[i].drawn_with < 0) continue;
    CHECK(shares[i].drawn_with % 2 == static_cast<int>(i % 2));
    CHECK(shares[static_cast<std::size_t>(shares[i].drawn_with)].drawn_with < 0);
    CHECK(shares[i].of_others == glm::vec3(0.0f));
  }
}

TEST_CASE("light groups: all light that falls on the casters stays, by channel") {
  Scene scene = two_clusters(40);
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    scene.lights[i].color = {1.0f, 0.5f, static_cast<float>(i) / 40.0f};
  const std::vector<LightShare> shares = grouped_in(scene, 3);
  glm::dvec3 before(0.0), after(0.0);
  double share = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const glm::dvec3 own = glm::dvec3(scene.lights[i].color) * static_cast<double>(scene.lights[i].intensity);
    const double reach = shares[i].on_casters / own.x;
    before += own * reach;
    if (shares[i].drawn_with >= 0) continue;
    after += (own + glm::dvec3(shares[i].of_others)) * reach;
    share += shares[i].share;
  }
  for (int c = 0; c < 3; ++c) CHECK(after[c] == Approx(before[c]).epsilon(1e-5));
  CHECK(share == Approx(1.0));
}

TEST_CASE("light groups: lights far apart as the casters see them stay alone, whatever is asked for") {
  CHECK(alone(grouped_in(two_clusters(40), 1)) == 2);
  Scene scene = two_clusters(40, 50.0);
  const Mesh glass = scene.meshes[1];
  scene.meshes.resize(1);
  for (const Light& light : scene.lights) {
    scene.meshes.push_back(glass);
    scene.meshes.back().lower += glm::vec3(light.position) - glm::vec3(0.0f, 1.0f, 0.0f);
    scene.meshes.back().upper += glm::vec3(light.position) - glm::vec3(0.0f, 1.0f, 0.0f);
  }
  std::vector<LightShare> shares(scene.lights.size(), {.on_casters = 1.0});
  group_lights(scene, effects_of(scene, {}), 1, shares);
  CHECK(alone(shares) == 40);
}

TEST_CASE("light groups: a lamp is far from another by as much as that is from the nearest caster") {
  // Both lamps are 10 m and more from the box around the glass, whose upper side is at 0.1 m.
  const auto alone_at = [](double apart) {
    Scene scene = two_clusters(0);
    scene.lights = {lamp({0.0, 10.1, 0.0}, 1.0f), lamp({apart, 10.1, 0.0}, 1.0f)};
    std::vector<LightShare> shares(2, {.on_casters = 1.0});
    group_lights(scene, effects_of(scene, {}), 1, shares);
    return alone(shares);
  };
  CHECK(alone_at(9.0) == 1);
  CHECK(alone_at(11.0) == 2);
}

TEST_CASE("light groups: a sun stands for no lamp, nor a lamp for a sun") {
  Scene scene = two_clusters(40);
  for (std::size_t i = 0; i < scene.lights.size(); i += 4) {
    scene.lights[i].type = LightType::Directional;
    scene.lights[i].direction = {0.0, -1.0, 0.0};
  }
  const std::vector<LightShare> shares = grouped_in(scene, 1);
  CHECK(alone(shares) == 3);
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (shares[i].drawn_with >= 0)
      CHECK(scene.lights[static_cast<std::size_t>(shares[i].drawn_with)].type == scene.lights[i].type);
}

TEST_CASE(
    "light groups: of lamps in one place one caustic is the sum of all, and glass shadows each of them") {
  Scene scene = two_clusters(20, 0.0);
  scene.meshes = {floor(1.5, -1.0, 0), box({-0.4, -0.4, -0.4}, {0.4, 0.4, 0.4}, 1)};
  scene.cameras = {camera_down(-0.5, 1.4)};
  for (Light& light : scene.lights) light.position = {0.5, 3.0, 0.25};
  Settings settings = small_settings(64, 64, 64);
  settings.least_light = settings.full_light = 0.0f;
  settings.most_lights = 0;
  const Image each = render(scene, settings, {"picture"})["picture"];
  settings.most_lights = 1;
  const Image one = render(scene, settings, {"picture"})["picture"];
  double sum = 0.0, off = 0.0;
  for (std::size_t i = 0; i < each.values.size(); ++i) {
    sum += static_cast<double>(each.values[i]);
    off += std::abs(static_cast<double>(each.values[i] - one.values[i]));
  }
  CHECK(sum > 0.0);
  CHECK(off < 0.004 * sum);
}
