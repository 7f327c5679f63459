#include "pipeline/scene/uv_density.hpp"

#include <array>
#include <cmath>

#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("uv density: how often a texture is laid over a metre, along u and along v") {
  // 2 m by 0.5 m in the plane x = z, the texture three times along the one, once along the other.
  const float side = 2.0f / std::sqrt(2.0f);
  Mesh mesh;
  for (const auto& [along, up, u, v] :
       {std::array{0.0f, 0.0f, 0.0f, 0.0f}, {side, 0.0f, 3.0f, 0.0f}, {side, 0.5f, 3.0f, 1.0f}})
    mesh.vertices.push_back({.position = {along, up, along}, .uv = {u, v}});
  mesh.indices = {0, 1, 2};
  for (const glm::vec2& density : uv_densities(mesh)) {
    CHECK(density.x == Approx(1.5));
    CHECK(density.y == Approx(2.0));
  }
}

TEST_CASE("uv density: larger triangles around a vertex count more, those without an area nothing") {
  Mesh mesh;
  const auto add = [&](float x, float z, float u) {
    mesh.vertices.push_back({.position = {x, 0.0f, z}, .uv = {u, 0.0f}});
  };
  // Around vertex 0: 3 square metres at 1 a metre, and 1 at 5 a metre.
  add(0.0f, 0.0f, 0.0f);
  add(3.0f, 0.0f, 3.0f);
  add(0.0f, 2.0f, 0.0f);
  add(-1.0f, 0.0f, -5.0f);
  mesh.indices = {0, 1, 2, 0, 2, 3, 0, 1, 1};
  const std::vector<glm::vec2> densities = uv_densities(mesh);
  CHECK(densities[0].x == Approx((3.0 * 1.0 + 1.0 * 5.0) / 4.0));
  CHECK(densities[1].x == Approx(1.0));
  CHECK(densities[3].x == Approx(5.0));
  CHECK(densities[0].y == 0.0f);
}
