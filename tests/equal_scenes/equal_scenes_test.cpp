// Pairs of scenes that say the same in other words and must look the same to the bit, and pairs
// that differ in one thing and must show it.
#include <functional>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

struct Case {
  Scene scene = sphere_scene(1.5f, 4);
  Settings settings = through_two_surfaces(small_settings(64, 64, 48));
};
using Change = std::function<void(Case&)>;

Rendering rendered(const Change& change) {
  Case c;
  c.scene.lights = {sun({0.2, -1.0, 0.1}, 1.0f)};
  c.scene.meshes.push_back(box({0.5, 0.0, 0.5}, {0.8, 0.2, 0.8}, 0));
  change(c);
  return render(c.scene, c.settings, {"aov_direct", "aov_caustic"});
}

// Direct light and caustics of every pixel, as hashes.
std::string look(const Change& change) {
  const Rendering r = rendered(change);
  return sha256(r["aov_direct"]) + sha256(r["aov_caustic"]);
}

const Change kNoChange = [](Case&) {};

void unindex(Mesh& mesh) {
  std::vector<Vertex> vertices;
  for (const std::uint32_t i : mesh.indices) vertices.push_back(mesh.vertices[i]);
  for (std::uint32_t i = 0; i < mesh.indices.size(); ++i) mesh.indices[i] = i;
  mesh.vertices = std::move(vertices);
}

// Everything twice as large and twice as far: exact in binary numbers.
void double_lengths(Case& c) {
  for (Mesh& mesh : c.scene.meshes) {
    for (Vertex& v : mesh.vertices) v.position *= 2.0f;
    mesh.lower *= 2.0f;
    mesh.upper *= 2.0f;
  }
  Camera& camera = c.scene.cameras[0];
  camera.position *= 2.0;
  for (double* length : {&camera.half_width, &camera.half_height, &camera.near, &camera.far}) *length *= 2.0;
}

}  // namespace

TEST_CASE("equal scenes: what is said in other words looks the same to the bit") {
  const std::string expected = look(kNoChange);
  const std::pair<const char*, Change> same[] = {
      {"rendered again", kNoChange},
      {"triangles that share no vertices",
       [](Case& c) {
         for (Mesh& m : c.scene.meshes) unindex(m);
       }},
      {"meshes in another order", [](Case& c) { std::swap(c.scene.meshes[0], c.scene.meshes[1]); }},
      {"another name, and a material that nothing uses",
       [](Case& c) {
         c.scene.meshes[1].name = "ball";
         c.scene.materials.push_back(glass(2.4f));
       }},
      {"another thickness: the shape says how long the way is",
       [](Case& c) { c.scene.materials[1].thickness = 7.0f; }},
      {"two interfaces asked for, as the closed mesh has",
       [](Case& c) { c.settings.interfaces = Interfaces::Two; }},
      {"an attenuation that takes nothing",
       [](Case& c) {
         c.scene.materials[1].attenuation_distance = 0.5f;
         c.scene.materials[1].attenuation_color = glm::vec3(1.0f);
       }},
      {"a second light that is off",
       [](Case& c) {
         c.scene.lights.push_back(sun({0.0, -1.0, 0.0}, 0.0f));
       }},
      {"everything twice as large", double_lengths},
  };
  for (const auto& [name, change] : same) {
    INFO(name);
    CHECK(look(change) == expected);
  }
}

TEST_CASE("equal scenes: what differs in one thing looks different") {
  const std::string first = look(kNoChange);
  const std::pair<const char*, Change> different[] = {
      {"the index", [](Case& c) { c.scene.materials[1].ior = 1.501f; }},
      {"one interface", [](Case& c) { c.settings.interfaces = Interfaces::One; }},
      {"absorption",
       [](Case& c) {
         c.scene.materials[1].attenuation_distance = 0.5f;
         c.scene.materials[1].attenuation_color = {1.0f, 0.99f, 1.0f};
       }},
      {"the paper's weights", [](Case& c) { c.settings.weights = Weights::Paper; }},
      {"point splats", [](Case& c) { c.settings.splat = Splat::Point; }},
      {"the grid", [](Case& c) { c.settings.grid = 65; }},
      {"the map", [](Case& c) { c.settings.map = 65; }},
      {"the paper's estimator with one step",
       [](Case& c) {
         c.settings.estimator = Estimator::Paper;
         c.settings.iterations = 1;
       }},
      {"the light's direction",
       [](Case& c) {
         c.scene.lights = {sun({0.21, -1.0, 0.1}, 1.0f)};
       }},
      {"the light's colour",
       [](Case& c) {
         c.scene.lights[0].color = {1.0f, 0.999f, 1.0f};
       }},
      {"the sphere's place",
       [](Case& c) {
         for (Vertex& v : c.scene.meshes[1].vertices) v.position.x += 0.01f;
         finish(c.scene.meshes[1], 1.0f);
       }},
      {"thin glass", [](Case& c) { c.scene.materials[1].thickness = 0.0f; }},
      {"a box that is gone", [](Case& c) { c.scene.meshes.pop_back(); }},
  };
  for (const auto& [name, change] : different) {
    INFO(name);
    CHECK(look(change) != first);
  }
}
