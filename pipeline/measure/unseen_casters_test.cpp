#include "pipeline/measure/unseen_casters.hpp"

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pilot.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A strip of light over the middle of a cube of side 1 m, whose top is 2.5 m below it. `half`: of the strip's
// length, along x, metres.
Light strip(double half) {
  Light light{.name = "strip", .type = LightType::Point, .intensity = 1.0f};
  light.position = {0.0, 4.0, 0.0};
  light.direction = {0.0, -1.0, 0.0};
  light.shape = LightShape::Rectangle;
  light.width = {2.0 * half, 0.0, 0.0};
  light.height = {0.0, 0.0, 0.01};
  return light;
}

double unseen_of(const std::vector<Mesh>& casters, const Light& light) {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = {floor(10.0, 0.0, 0)};
  scene.meshes.insert(scene.meshes.end(), casters.begin(), casters.end());
  scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
  scene.cameras = {camera_down(0.2, 1.0)};
  const Settings settings;
  const Effects effects = effects_of(scene, settings);
  const RayTables tables(scene, effects, pilot().device);
  const LightPaths paths(tables, effects, settings, pilot().registry);
  std::set<int> meshes;
  for (std::size_t i = 1; i < scene.meshes.size(); ++i) meshes.insert(static_cast<int>(i));
  return unseen_share(scene, meshes, paths, DrawnPoints(scene, light), light.position);
}

// What the strip sends to a level or an upright square of 1 m whose middle is at (x, y, 0), by a sum over
// both; nothing to a back.
double onto_square(double half, double x, double y, bool upright) {
  constexpr int n = 24;
  const auto at = [](int i) { return (i + 0.5) / n - 0.5; };
  const glm::dvec3 normal = upright ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  double sum = 0.0;
  for (int l = 0; l < 4 * n; ++l)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const glm::dvec3 p = upright ? glm::dvec3(x, y + at(i), at(j)) : glm::dvec3(x + at(i), y, at(j));
        const glm::dvec3 way = glm::dvec3(2.0 * half * ((l + 0.5) / (4 * n) - 0.5), 4.0, 0.0) - p;
        sum += std::max(glm::dot(way, normal), 0.0) * way.y / std::pow(glm::dot(way, way), 2.0);
      }
  return sum;
}

}  // namespace

TEST_CASE("unseen casters: a small light's view shows all that it lights") {
  CHECK(unseen_of({box({-0.5, 0.5, -0.5}, {0.5, 1.5, 0.5}, 1)}, strip(0.01)) == 0.0);
}

TEST_CASE("unseen casters: a strip over a cube lights two sides that its middle does not see") {
  for (const double half : {1.0, 3.0}) {
    const double sides = 2.0 * onto_square(half, 0.5, 1.0, true), top = onto_square(half, 0.0, 1.5, false);
    CHECK(unseen_of({box({-0.5, 0.5, -0.5}, {0.5, 1.5, 0.5}, 1)}, strip(half)) ==
          Approx(sides / (sides + top)).margin(0.015));
    CHECK(sides > 0.02 * top);
  }
}

TEST_CASE("unseen casters: what stands below another is lit from aside, where the middle does not see it") {
  const Mesh above = box({-0.5, 2.4, -0.5}, {0.5, 2.5, 0.5}, 1),
             below = box({-0.5, 0.5, -0.5}, {0.5, 0.6, 0.5}, 1);
  CHECK(unseen_of({above, below}, strip(0.01)) == 0.0);
  CHECK(unseen_of({above, below}, strip(3.0)) > unseen_of({above}, strip(3.0)) + 0.1);
}
