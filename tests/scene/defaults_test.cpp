// What a scene is completed with.
#include "pipeline/scene/defaults.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

// A glass object of the given bounds; its triangles do not matter here.
Scene glass(const glm::vec3& lower, const glm::vec3& upper) {
  Scene scene;
  Material material;
  material.transmission = 1.0f;
  scene.materials.push_back(material);
  Mesh mesh;
  mesh.lower = lower;
  mesh.upper = upper;
  mesh.vertices.resize(3);
  scene.meshes.push_back(mesh);
  return scene;
}

}  // namespace

TEST_CASE("A bare glass object gets a ground, a sun, a camera and a sky, and says so") {
  Scene scene = glass({-1, -2, -1}, {1, 2, 1});
  complete_scene(scene);
  REQUIRE(scene.meshes.size() == 2);
  const Mesh& ground = scene.meshes[1];
  CHECK(ground.upper.y < -2.0f);
  CHECK(ground.upper.y > -2.01f);
  CHECK(ground.upper.x - ground.lower.x == Approx(24));
  CHECK(is_receiver(scene.materials.at(static_cast<std::size_t>(ground.material))));
  CHECK(ground.object != scene.meshes[0].object);
  const auto corner = [&](std::size_t i) { return ground.vertices[ground.indices[i]].position; };
  for (const std::size_t t : {0u, 3u}) {
    CHECK(glm::cross(corner(t + 1) - corner(t), corner(t + 2) - corner(t)).y > 0);
  }
  REQUIRE(scene.lights.size() == 1);
  CHECK(glm::length(scene.lights[0].direction) == Approx(1));
  CHECK(scene.lights[0].intensity == 10.0f);
  REQUIRE(scene.cameras.size() == 1);
  CHECK(scene.environment.zenith.x > 0.0f);
  CHECK(scene.notes.size() == 4);
}

TEST_CASE("The added camera sees the object's corners and their shadows") {
  Scene scene = glass({-1, -2, -1}, {1, 2, 1});
  complete_scene(scene);
  const Camera& camera = scene.cameras.at(0);
  CHECK(glm::dot(camera.right, camera.up) == Approx(0).margin(1e-12));
  const double slope = 0.3650;  // tan(0.35)
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 p((i & 1) ? 1 : -1, (i & 2) ? 2 : -2, (i & 4) ? 1 : -1);
    const glm::dvec3 shadow = p + scene.lights[0].direction * ((-2 - p.y) / scene.lights[0].direction.y);
    for (const glm::dvec3& point : {p, shadow}) {
      const glm::dvec3 seen = point - camera.position;
      const double depth = glm::dot(seen, camera.forward);
      CHECK(depth > camera.near);
      CHECK(std::abs(glm::dot(seen, camera.up)) < slope * depth);
      CHECK(std::abs(glm::dot(seen, camera.right)) < slope * depth);
    }
  }
}

TEST_CASE("What the scene has is kept") {
  Scene scene = glass(glm::vec3(-1), glm::vec3(1));
  scene.materials.emplace_back();
  Mesh floor;
  floor.material = 1;
  floor.vertices.resize(3);
  scene.meshes.push_back(floor);
  scene.lights.emplace_back();
  scene.cameras.emplace_back();
  scene.environment.zenith = glm::vec3(1);
  complete_scene(scene);
  CHECK(scene.meshes.size() == 2);
  CHECK(scene.lights.size() == 1);
  CHECK(scene.cameras.size() == 1);
  CHECK(scene.environment.horizon == glm::vec3(0));
  CHECK(scene.notes.empty());
}

TEST_CASE("Smooth metal is a mirror, rough metal receives") {
  Material material;
  material.roughness = 0.2f;
  CHECK(is_mirror(material));
  CHECK_FALSE(is_receiver(material));
  material.roughness = 0.3f;
  CHECK(is_receiver(material));
}

TEST_CASE("The sky follows the light's level: candela fall off with the square of the distance") {
  Scene scene = glass(glm::vec3(-1), glm::vec3(1));
  Light lamp;
  lamp.type = LightType::Point;
  lamp.intensity = 100.0f;
  lamp.position = {0, 5, 0};
  scene.lights.push_back(lamp);
  CHECK(light_level(scene) == Approx(4.0));
}

TEST_CASE("A scene without anything still gets a light and a camera") {
  Scene scene;
  complete_scene(scene);
  CHECK(scene.meshes.empty());
  CHECK(scene.lights.size() == 1);
  CHECK(scene.cameras.size() == 1);
}
