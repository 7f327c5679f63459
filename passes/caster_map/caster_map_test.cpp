#include "passes/caster_map/caster_map.hpp"

#include "tests/support/caster_bench.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("caster_map: the samples that passed count the texels the light sees") {
  // A 1 m square in a 2 m window of 8 x 8 texels covers the middle 4 x 4.
  const PassImages out = seen_by_light(caster_map_pass(), kFront);
  CHECK(out.result.samples_passed == 16);
  int covered = 0;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) covered += out["caster_position"].at(x, y, 3) != 0.0f;
  CHECK(covered == 16);
}

TEST_CASE("caster_map: a grid vertex has a position, a unit normal and its material's row") {
  const PassImages out = seen_by_light(caster_map_pass(), kFront);
  const glm::vec4 position = texel(out["caster_position"], 2, 2);
  CHECK(position.x == Approx(-0.375));
  CHECK(position.y == Approx(1.0));
  CHECK(position.w == 2.0f);  // a front face, of the first triangle
  CHECK(texel(out["caster_normal"], 2, 2) == glm::vec4(0.0f, 1.0f, 0.0f, 3.0f));
}

TEST_CASE("caster_map: a back face is kept and marked") {
  CHECK(seen_by_light(caster_map_pass(), kBack)["caster_position"].at(3, 3, 3) == -3.0f);
}

TEST_CASE(
    "caster_map: of the camera, a pixel holds position, side, normal and material of the nearest glass") {
  const glm::vec3 corners[4] = {{-1, 2, 1}, {0, 2, 1}, {0, 2, -1}, {-1, 2, -1}};
  MeshData mesh = quad(corners, {0.0f, 2.0f, 0.0f});
  const PassImages front = seen_by_camera(caster_map_pass(), mesh);
  CHECK(texel(front["caster_position"], 1, 1) == glm::vec4(-0.25f, 2.0f, 0.25f, 2.0f));
  CHECK(texel(front["caster_normal"], 1, 1) == glm::vec4(0.0f, 1.0f, 0.0f, 3.0f));
  CHECK(texel(front["caster_position"], 2, 1) == glm::vec4(0.0f));
  std::swap(mesh.indices[1], mesh.indices[2]);
  std::swap(mesh.indices[4], mesh.indices[5]);
  CHECK(seen_by_camera(caster_map_pass(), mesh)["caster_position"].at(1, 1, 3) == -2.0f);
}
