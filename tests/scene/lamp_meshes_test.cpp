// Which of the meshes that shine are taken for lamps.
#include "pipeline/scene/lamp_meshes.hpp"

#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr double kSun = 10.0;  // lux

int shining(Scene& scene, float nit) {
  Material material = diffuse(0.5f);
  material.double_sided = false;
  material.emissive = glm::vec3(nit);
  scene.materials.push_back(material);
  return static_cast<int>(scene.materials.size()) - 1;
}

Mesh downwards(Mesh mesh) {
  std::reverse(mesh.indices.begin(), mesh.indices.end());
  return mesh;
}

// A floor, 6 x 6 m, and a panel 2 m above it of half side 0.15 m that shines downwards.
Scene under_lamp(float nit) {
  Scene scene;
  scene.materials = {diffuse(0.8f)};
  scene.meshes = {floor(3.0, 0.0, 0)};
  const int lit = shining(scene, nit);
  scene.meshes.push_back(downwards(floor(0.15, 2.0, lit)));
  return scene;
}

}  // namespace

TEST_CASE("lamp meshes: a scene's only light, if it lights it, stands in the place of a sun") {
  const Lamps lamps = choose_lamps(under_lamp(20000.0f), kSun, 16);
  REQUIRE(lamps.lights.size() == 1);
  CHECK(lamps.instead_of_sun);
  CHECK(lamps.dim.empty());
  CHECK(lamps.lights[0].emitter == 1);
  CHECK(lamps.lights[0].intensity == Approx(1800.0));
  CHECK(lamps.lights[0].samples == 16);
}

TEST_CASE("lamp meshes: what is much weaker than a sun is left to glow, and a sun is called for") {
  // 0.009 cd give at most 0.002 lux below.
  const Lamps lamps = choose_lamps(under_lamp(0.1f), kSun, 16);
  CHECK(lamps.lights.empty());
  CHECK_FALSE(lamps.instead_of_sun);
  REQUIRE(lamps.dim.size() == 1);
  CHECK(lamps.dim[0].mesh == 1);
  CHECK(lamps.dim[0].why.find("less than a tenth") != std::string::npos);
}

TEST_CASE("lamp meshes: a room is lit by its ceiling's panel, however weak that is") {
  Scene scene;
  scene.materials = {diffuse(0.8f)};
  scene.meshes = {floor(1.0, 0.0, 0), floor(1.0, 2.0, 0)};
  scene.meshes.push_back(downwards(floor(0.5, 2.0, shining(scene, 0.01f))));
  const Lamps lamps = choose_lamps(scene, kSun, 16);
  CHECK(lamps.lights.size() == 1);
  CHECK(lamps.instead_of_sun);
}

TEST_CASE("lamp meshes: one that shines onto nothing is none") {
  Scene scene = under_lamp(20000.0f);
  std::reverse(scene.meshes[1].indices.begin(), scene.meshes[1].indices.end());  // upwards
  const Lamps lamps = choose_lamps(scene, kSun, 16);
  CHECK(lamps.lights.empty());
  CHECK_FALSE(lamps.instead_of_sun);
}

TEST_CASE("lamp meshes: beside lights of its own a scene's meshes count where they add a tenth") {
  // Below the panel 450 lux, over most of the floor more than 20.
  for (const auto& [lux, counts] : {std::pair{100.0f, true}, {100000.0f, false}}) {
    Scene scene = under_lamp(20000.0f);
    scene.lights = {sun({0.0, -1.0, 0.0}, lux)};
    const Lamps lamps = choose_lamps(scene, kSun, 16);
    INFO("sun of " << lux << " lux");
    CHECK(lamps.lights.size() == (counts ? 1 : 0));
    CHECK(lamps.dim.size() == (counts ? 0 : 1));
    CHECK_FALSE(lamps.instead_of_sun);
  }
}

TEST_CASE("lamp meshes: in the shade of a scene's lights 30 % of them are taken to come from all around") {
  // Below the panel 450 lux, over a tenth of the floor more than 200; a roof keeps the sun off.
  for (const auto& [lux, counts] : {std::pair{3300.0f, true}, {20000.0f, false}}) {
    Scene scene = under_lamp(20000.0f);
    scene.meshes.push_back(floor(3.0, 3.0, 0));
    scene.lights = {sun({0.0, -1.0, 0.0}, lux)};
    INFO("sun of " << lux << " lux");
    CHECK(choose_lamps(scene, kSun, 16).lights.size() == (counts ? 1 : 0));
  }
}

TEST_CASE("lamp meshes: lamps behind glass shine, lamps in a closed box do not") {
  Scene scene = under_lamp(20000.0f);
  scene.materials.push_back(glass(1.5f));
  scene.meshes.push_back(sphere({0.0, 2.0, 0.0}, 0.5, 3, 2));
  CHECK(choose_lamps(scene, kSun, 16).lights.size() == 1);
  // Inside of an opaque ball it lights nothing but that, a thirtieth of all surfaces.
  scene.meshes.back() = sphere({0.0, 2.0, 0.0}, 0.3, 3, 0);
  CHECK(choose_lamps(scene, kSun, 16).lights.empty());
}

TEST_CASE("lamp meshes: they share the samples by their flux") {
  Scene scene = under_lamp(20000.0f);
  const int weaker = shining(scene, 20000.0f / 3.0f);
  Mesh second = downwards(floor(0.15, 1.9, weaker));
  for (Vertex& vertex : second.vertices) vertex.position.x += 1.0f;
  second.lower.x += 1.0f;
  second.upper.x += 1.0f;
  scene.meshes.push_back(second);
  const Lamps lamps = choose_lamps(scene, kSun, 16);
  REQUIRE(lamps.lights.size() == 2);
  CHECK(lamps.lights[0].samples == 12);
  CHECK(lamps.lights[1].samples == 4);
}

// Radii over the distance to the scene's middle, about 1.7 m away: 0.13 and 0.02.
TEST_CASE(
    "lamp meshes: beside glass a wide lamp has all samples, half of them among the glass, a narrow one a "
    "quarter") {
  struct Case {
    double half_side, glass_at;
    int samples;
  };
  for (const auto& [half_side, glass_at, samples] : {Case{0.15, 0.5, 16}, {0.15, 2.0, 8}, {0.02, 0.5, 4}}) {
    Scene scene;
    scene.materials = {diffuse(0.8f), glass(1.5f)};
    scene.meshes = {floor(3.0, 0.0, 0), sphere({0.0, glass_at, 0.0}, 0.4, 1, 1)};
    scene.meshes.push_back(downwards(floor(half_side, 2.0, shining(scene, 2e6f))));
    const Lamps lamps = choose_lamps(scene, kSun, 16);
    INFO(half_side << " m, glass at " << glass_at << " m");
    REQUIRE(lamps.lights.size() == 1);
    CHECK(lamps.lights[0].samples == samples);
  }
}

TEST_CASE("lamp meshes: no more than 16 are lights, the strongest") {
  Scene scene;
  scene.materials = {diffuse(0.8f)};
  scene.meshes = {floor(30.0, 0.0, 0)};
  for (int i = 0; i < 20; ++i) {
    Mesh lamp = downwards(floor(0.5, 1.0, shining(scene, 1000.0f + static_cast<float>(i))));
    const glm::vec3 aside(static_cast<float>(10 * (i % 5) - 20), 0.0f, static_cast<float>(10 * (i / 5) - 15));
    for (Vertex& vertex : lamp.vertices) vertex.position += aside;
    lamp.lower += aside;
    lamp.upper += aside;
    scene.meshes.push_back(lamp);
  }
  const Lamps lamps = choose_lamps(scene, kSun, 16);
  // Each is the brightest thing on a twentieth of the floor or not; none of the weakest is before a stronger.
  CHECK(lamps.lights.size() <= 16);
  CHECK(lamps.lights.size() + lamps.dim.size() == 20);
  for (std::size_t i = 1; i < lamps.lights.size(); ++i)
    CHECK(lamps.lights[i - 1].intensity >= lamps.lights[i].intensity);
}

TEST_CASE("lamp meshes: a spot light of the scene counts within its cone, and by its distance, alone") {
  // Below the panel 450 lux. A spot from 3 m of height gives 1/9 of its intensity where it points.
  for (const auto& [candela, inner, up, counts] : {std::tuple{90000.0f, 1.5f, false, false},
                                                   {90000.0f, 0.001f, false, true},
                                                   {90000.0f, 1.5f, true, true},
                                                   {900.0f, 1.5f, false, true}}) {
    Scene scene = under_lamp(20000.0f);
    Light spot{.name = "spot", .type = LightType::Spot, .intensity = candela};
    spot.position = {0.0, 3.0, 0.0};
    spot.direction = {0.0, up ? 1.0 : -1.0, 0.0};
    spot.inner_cone = spot.outer_cone = inner;
    scene.lights = {spot};
    INFO(candela << " cd in " << inner << (up ? ", upwards" : ""));
    CHECK(choose_lamps(scene, kSun, 16).lights.size() == (counts ? 1 : 0));
  }
}
