#include "passes/caster_map/caster_map.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Seen from above, the corners in this order wind counter-clockwise: the front.
const glm::vec3 kFront[4] = {{-0.5, 1, 0.5}, {0.5, 1, 0.5}, {0.5, 1, -0.5}, {-0.5, 1, -0.5}};
const glm::vec3 kBack[4] = {{-0.5, 1, -0.5}, {0.5, 1, -0.5}, {0.5, 1, 0.5}, {-0.5, 1, 0.5}};

PassImages draw(const PassDefinition& definition, const glm::vec3 (&corners)[4]) {
  return run_pass(definition, {.width = 8,
                               .height = 8,
                               .uniforms = uniform_bytes(caster_map_uniforms(down(1.0, 4.0, 8.0), 3)),
                               .mesh = quad(corners, {0.0f, 2.0f, 0.0f})});
}

}  // namespace

TEST_CASE("caster_map: the samples that passed count the texels the light sees") {
  // A 1 m square in a 2 m window of 8 x 8 texels covers the middle 4 x 4.
  const PassImages out = draw(definition_of(caster_map_pass()), kFront);
  CHECK(out.result.samples_passed == 16);
  int covered = 0;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) covered += out["caster_position"].at(x, y, 3) != 0.0f;
  CHECK(covered == 16);
}

TEST_CASE("caster_map: a grid vertex has a position, a unit normal and its material's row") {
  const PassImages out = draw(definition_of(caster_map_pass()), kFront);
  const glm::vec4 position = texel(out["caster_position"], 2, 2);
  CHECK(position.x == Approx(-0.375));
  CHECK(position.y == Approx(1.0));
  CHECK(position.w == 1.0f);
  CHECK(texel(out["caster_normal"], 2, 2) == glm::vec4(0.0f, 1.0f, 0.0f, 3.0f));
}

TEST_CASE("caster_map: a back face is kept and marked") {
  CHECK(draw(definition_of(caster_map_pass()), kBack)["caster_position"].at(3, 3, 3) == -1.0f);
}

TEST_CASE(
    "caster_map: of the camera, a pixel holds position, side, normal and material of the nearest glass") {
  const View view = down(1.0, 10.0, 20.0);
  const Pass pass = caster_map_pass();
  const Effects effects;
  const glm::vec3 corners[4] = {{-1, 2, 1}, {0, 2, 1}, {0, 2, -1}, {-1, 2, -1}};
  const auto draw = [&](const MeshData& mesh) {
    return run_pass(definition_of(pass, {}, kCamera),
                    {.width = 4,
                     .height = 4,
                     .uniforms = pass.uniforms({.effects = &effects, .camera = &view, .material_row = 3}),
                     .mesh = mesh});
  };
  MeshData mesh = quad(corners, {0.0f, 2.0f, 0.0f});
  const PassImages front = draw(mesh);
  CHECK(texel(front["caster_position"], 1, 1) == glm::vec4(-0.25f, 2.0f, 0.25f, 1.0f));
  CHECK(texel(front["caster_normal"], 1, 1) == glm::vec4(0.0f, 1.0f, 0.0f, 3.0f));
  CHECK(texel(front["caster_position"], 2, 1) == glm::vec4(0.0f));
  std::swap(mesh.indices[1], mesh.indices[2]);
  std::swap(mesh.indices[4], mesh.indices[5]);
  CHECK(draw(mesh)["caster_position"].at(1, 1, 3) == -1.0f);
}
