// What of a scene is the thing, and what is its floor.
#include "pipeline/scene/surroundings.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A glass ball of radius 1 around the origin, after these receivers.
Surroundings around_ball(std::vector<Mesh> others) {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = std::move(others);
  scene.meshes.push_back(sphere(glm::dvec3(0.0), 1.0, 2, 1));
  return surroundings_of(scene);
}

std::vector<Mesh> walls_of_a_room(double half) {
  const double thick = 0.1;
  return {box({-half, -half, -half}, {half, -half + thick, half}, 0),
          box({-half, half - thick, -half}, {half, half, half}, 0),
          box({-half, -half, -half}, {-half + thick, half, half}, 0),
          box({half - thick, -half, -half}, {half, half, half}, 0),
          box({-half, -half, -half}, {half, half, -half + thick}, 0),
          box({-half, -half, half - thick}, {half, half, half}, 0)};
}

Mesh joined(const std::vector<Mesh>& meshes) {
  Mesh all;
  for (const Mesh& mesh : meshes) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const std::uint32_t index : mesh.indices) all.indices.push_back(first + index);
  }
  finish(all, 1.0f);
  return all;
}

}  // namespace

TEST_CASE("surroundings: a floor reaches beyond the thing by half its width on each side") {
  CHECK_FALSE(around_ball({floor(1.9, -1.0, 0)}).has_floor);
  CHECK(around_ball({floor(2.1, -1.0, 0)}).has_floor);
  CHECK(around_ball({floor(2.1, -40.0, 0)}).has_floor);
  CHECK_FALSE(around_ball({floor(2.1, 1.0, 0)}).has_floor);
}

TEST_CASE("surroundings: a base, a plinth and a tray belong to the thing") {
  for (const double half : {1.0, 1.2, 1.6}) {
    const Surroundings found = around_ball({box({-half, -1.5, -half}, {half, -1.0, half}, 0)});
    CHECK_FALSE(found.has_floor);
    CHECK(found.around == std::vector<bool>{false, false});
    CHECK(found.thing.lower.y == -1.5);
  }
}

TEST_CASE("surroundings: a table is a floor to what stands on it, near its edge too, but its legs are none") {
  Mesh table = joined({box({-6, -1.2, -4}, {6, -1, 4}, 0), box({-6, -8, -4}, {-5.5, -1.2, -3.5}, 0),
                       box({5.5, -8, 3.5}, {6, -1.2, 4}, 0)});
  const Surroundings found = around_ball({table});
  CHECK(found.has_floor);
  CHECK(found.around == std::vector<bool>{true, false});
  CHECK(found.thing.lower.y == -1.0);
  for (Vertex& vertex : table.vertices) vertex.position.x += 4.5f;  // its end is 1.5 beside the ball's middle
  finish(table, 1.0f);
  CHECK(around_ball({table}).has_floor);
  CHECK_FALSE(around_ball({box({-0.2, -3.0, -0.2}, {0.2, -1.0, 0.2}, 0)}).has_floor);
}

TEST_CASE("surroundings: a room has its floor, in one mesh or in six, though its walls stand near") {
  for (const double half : {3.0, 20.0}) {
    CHECK(around_ball(walls_of_a_room(half)).has_floor);
    const Surroundings one = around_ball({joined(walls_of_a_room(half))});
    CHECK(one.has_floor);
    CHECK(one.thing.upper.x == 1.0);
  }
  // In its corner: half of the places beside the ball lie behind a wall.
  Mesh corner = joined(walls_of_a_room(3.0));
  for (Vertex& vertex : corner.vertices) vertex.position += glm::vec3(1.8f, 0.0f, 1.8f);
  finish(corner, 1.0f);
  CHECK(around_ball({corner}).has_floor);
}

TEST_CASE("surroundings: a large opaque thing beside the glass is shown whole, a wall behind it is not") {
  const Surroundings beside = around_ball({box({2, -1, -4}, {10, 7, 4}, 0)});
  CHECK(beside.thing.upper.x == 10.0);
  CHECK_FALSE(beside.has_floor);
  const Surroundings before = around_ball({box({-8, -8, -3}, {8, 8, -2.9}, 0)});
  CHECK(before.thing.upper.x == 1.0);
  CHECK_FALSE(before.has_floor);
}

TEST_CASE("surroundings: a body with small glass parts is the thing, and nothing of it a floor") {
  // Eyes of a tenth of the body's size, set into its front.
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = {sphere(glm::dvec3(0.0), 1.0, 3, 0), sphere({-0.3, 0.5, 0.8}, 0.1, 1, 1),
                  sphere({0.3, 0.5, 0.8}, 0.1, 1, 1)};
  const Surroundings found = surroundings_of(scene);
  CHECK(found.around == std::vector<bool>(3));
  CHECK(found.thing.lower.y == Approx(-1.0));
}

TEST_CASE("surroundings: without glass too, what stands on a floor is the thing, and alone a floor is") {
  Scene scene;
  scene.materials = {diffuse(0.8f)};
  scene.meshes = {sphere(glm::dvec3(0.0), 1.0, 2, 0), floor(5.0, -1.0, 0)};
  CHECK(surroundings_of(scene).has_floor);
  CHECK(surroundings_of(scene).thing.upper.x == Approx(1.0));
  scene.meshes.erase(scene.meshes.begin());
  CHECK_FALSE(surroundings_of(scene).has_floor);
  CHECK(surroundings_of(scene).thing.upper.x == 5.0);
  CHECK(surroundings_of(Scene{}).thing.empty());
}
