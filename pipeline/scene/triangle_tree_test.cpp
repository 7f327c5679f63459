#include "pipeline/scene/triangle_tree.hpp"

#include <random>

#include "pipeline/scene/exact.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Scene scene_of(std::vector<Mesh> meshes) {
  Scene scene;
  scene.materials.resize(1);
  scene.meshes = std::move(meshes);
  return scene;
}

// A mesh of triangles anywhere in a cube of 2 m.
Mesh scattered(int triangles, unsigned seed) {
  std::mt19937 random(seed);
  const auto coordinate = [&] { return static_cast<float>(random() % 2001) * 1e-3f - 1.0f; };
  Mesh mesh;
  for (int i = 0; i < 3 * triangles; ++i) {
    mesh.vertices.push_back({.position = {coordinate(), coordinate(), coordinate()}});
    mesh.indices.push_back(static_cast<std::uint32_t>(i));
  }
  return mesh;
}

}  // namespace

TEST_CASE("triangle tree: a ray meets the nearest of two floors, on the side that it comes from") {
  const Scene scene = scene_of({floor(1.0, 0.0, 0), floor(1.0, 2.0, 0)});
  const TriangleTree tree(scene, {0, 1});
  const auto above = tree.nearest({0.25, 5.0, 0.5}, {0, -1, 0});
  REQUIRE(above);
  CHECK(above->id.mesh == 1);
  CHECK(above->distance == 3.0);
  CHECK(above->front);
  CHECK(position_of(scene, *above) == glm::dvec3(0.25, 2.0, 0.5));
  CHECK(plane_normal(scene, above->id) == glm::dvec3(0, 1, 0));
  const auto between = tree.nearest({0.25, 0.5, 0.5}, {0, 1, 0});
  REQUIRE(between);
  CHECK(between->id.mesh == 1);
  CHECK_FALSE(between->front);
  CHECK_FALSE(tree.nearest({0.25, 5.0, 0.5}, {0, 1, 0}));
  CHECK_FALSE(tree.nearest({1.25, 5.0, 0.5}, {0, -1, 0}));
}

TEST_CASE("triangle tree: the triangle that a ray starts on is left out, and so is a mesh on request") {
  const Scene scene = scene_of({floor(1.0, 0.0, 0), floor(1.0, 2.0, 0)});
  const TriangleTree tree(scene, {0, 1});
  const auto start = tree.nearest({0.25, 5.0, 0.5}, {0, -1, 0});
  REQUIRE(start);
  CHECK(tree.nearest({0.25, 2.0, 0.5}, {0, -1, 0})->id == start->id);
  CHECK(tree.nearest({0.25, 2.0, 0.5}, {0, -1, 0}, start->id)->id.mesh == 0);
  CHECK(tree.nearest({0.25, 5.0, 0.5}, {0, -1, 0}, {}, 1)->id.mesh == 0);
}

TEST_CASE("triangle tree: no ray from within a closed body slips through an edge or a corner") {
  const Scene scene = scene_of({sphere({0.3, -0.2, 0.1}, 1.0, 3, 0)});
  const TriangleTree tree(scene, {0});
  const Mesh& mesh = scene.meshes.front();
  const glm::dvec3 from(0.3, -0.2, 0.1);
  int missed = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 a(mesh.vertices[mesh.indices[i + k]].position),
          b(mesh.vertices[mesh.indices[i + (k + 1) % 3]].position);
      for (const double t : {0.0, 0.3, 0.5, 1.0 / 7.0}) missed += !tree.nearest(from, a + (b - a) * t - from);
    }
  CHECK(missed == 0);
}

TEST_CASE("triangle tree: finds what a search through all triangles finds") {
  Mesh twice = scattered(300, 1);
  // The same triangle twice: the first in the scene counts.
  for (std::size_t i = 0; i < 30; ++i) twice.indices.push_back(static_cast<std::uint32_t>(i));
  const Scene scene = scene_of({twice, scattered(200, 2)});
  const TriangleTree tree(scene, {0, 1});
  std::vector<Scene> single;
  std::mt19937 random(3);
  const auto coordinate = [&] { return static_cast<double>(random() % 4001) * 1e-3 - 2.0; };
  int met = 0;
  for (int ray = 0; ray < 300; ++ray) {
    const glm::dvec3 from(coordinate(), coordinate(), coordinate()),
        along(coordinate(), coordinate(), coordinate());
    std::optional<TriangleHit> best;
    for (int m = 0; m < 2; ++m) {
      const Mesh& mesh = scene.meshes[static_cast<std::size_t>(m)];
      for (std::size_t t = 0; 3 * t < mesh.indices.size(); ++t) {
        Scene one = scene_of({mesh});
        one.meshes[0].indices = {mesh.indices[3 * t], mesh.indices[3 * t + 1], mesh.indices[3 * t + 2]};
        auto hit = TriangleTree(one, {0}).nearest(from, along);
        if (!hit || (best && hit->distance >= best->distance)) continue;
        hit->id = {m, static_cast<int>(t)};
        best = hit;
      }
    }
    const auto found = tree.nearest(from, along);
    REQUIRE(found.has_value() == best.has_value());
    if (!found) continue;
    ++met;
    CHECK(found->id == best->id);
    CHECK(found->distance == best->distance);
  }
  CHECK(met > 40);
}

TEST_CASE("triangle tree: of triangles that are divided on several threads each is found") {
  const Scene scene = scene_of({sphere({0.0, 0.0, 0.0}, 1.0, 5, 0)});
  const Mesh& mesh = scene.meshes[0];
  REQUIRE(mesh.indices.size() / 3 == 20480);
  for (const int threads : {1, 3}) {
    const TriangleTree tree(scene, {0}, threads);
    int found = 0;
    for (std::size_t t = 0; 3 * t < mesh.indices.size(); ++t) {
      glm::dvec3 middle(0.0);
      for (std::size_t k = 0; k < 3; ++k)
        middle += glm::dvec3(mesh.vertices[mesh.indices[3 * t + k]].position);
      const auto hit = tree.nearest({0.0, 0.0, 0.0}, middle);
      found += hit && hit->id == TriangleId{0, static_cast<int>(t)};
    }
    CHECK(found == 20480);
  }
}

TEST_CASE(
    "triangle tree: triangles without area, rays without direction and empty scenes are met by nothing") {
  Mesh line = floor(1.0, 0.0, 0);
  line.indices = {0, 1, 1, 2, 2, 2};
  const Scene scene = scene_of({line});
  CHECK(TriangleTree(scene, {0}).empty());
  CHECK_FALSE(TriangleTree(scene, {0}).nearest({0, 1, 0}, {0, -1, 0}));
  const Scene plain = scene_of({floor(1.0, 0.0, 0)});
  CHECK_FALSE(TriangleTree(plain, {0}).nearest({0, 1, 0}, {0, 0, 0}));
  CHECK_FALSE(TriangleTree(plain, {0}).nearest({0, 1, 0}, {0, -1.0 / 0.0, 0}));
}
