#include "pipeline/measure/meshes_in_the_way.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A ball of glass on the x axis with a wall before it, and a floor below.
Scene walled() {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = {floor(10.0, -2.0, 0), box({2, -1, -1}, {3, 1, 1}, 1), box({1, -2, -2}, {1.1, 2, 2}, 0)};
  return scene;
}

int before_the_ball(const Scene& scene) {
  std::vector<int> lights;
  for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) lights.push_back(light);
  return MeshesInTheWay(scene).before(1, lights);
}

}  // namespace

TEST_CASE("meshes in the way: what most of a caster is hidden behind, of a sun and of a lamp") {
  Scene scene = walled();
  scene.lights = {sun({1.0, 0.0, 0.0}, 1.0f)};
  CHECK(before_the_ball(scene) == 2);
  Light lamp;
  lamp.type = LightType::Point;
  scene.lights = {lamp};
  CHECK(before_the_ball(scene) == 2);
  // Its own light comes through the wall that shines.
  scene.lights[0].emitter = 2;
  CHECK(before_the_ball(scene) == -1);
}

TEST_CASE("meshes in the way: nothing where light comes freely, whatever lies behind the caster") {
  Scene scene = walled();
  scene.lights = {sun({-1.0, 0.0, 0.0}, 1.0f)};
  CHECK(before_the_ball(scene) == -1);
  scene.lights.clear();
  CHECK(before_the_ball(scene) == -1);
}
