#include "passes/caster_exit_map/caster_exit_map.hpp"

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

TEST_CASE("caster_exit_map: only back faces are drawn") {
  CHECK(draw(definition_of(caster_exit_map_pass()), kFront)["caster_exit_position"].at(3, 3, 3) == 0.0f);
  const PassImages out = draw(definition_of(caster_exit_map_pass()), kBack);
  CHECK(out["caster_exit_position"].at(3, 3, 3) == 1.0f);
  CHECK(texel(out["caster_exit_normal"], 3, 3) == glm::vec4(0.0f, 1.0f, 0.0f, 1.0f));
}

TEST_CASE("caster_exit_map: of the camera, only back faces are seen") {
  const View view = down(1.0, 10.0, 20.0);
  const Pass pass = caster_exit_map_pass();
  const Effects effects;
  const auto draw = [&](const MeshData& mesh) {
    return run_pass(definition_of(pass, {}, kCamera),
                    {.width = 4,
                     .height = 4,
                     .uniforms = pass.uniforms({.effects = &effects, .camera = &view, .material_row = 3}),
                     .mesh = mesh});
  };
  const glm::vec3 up[4] = {{-1, 2, 1}, {1, 2, 1}, {1, 2, -1}, {-1, 2, -1}};
  const glm::vec3 under[4] = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
  CHECK(texel(draw(quad(up, {0, 1, 0}))["caster_exit_position"], 1, 1) == glm::vec4(0.0f));
  const PassImages back = draw(quad(under, {0, -1, 0}));
  CHECK(texel(back["caster_exit_position"], 1, 1) == glm::vec4(-0.25f, 1.0f, 0.25f, 1.0f));
  CHECK(texel(back["caster_exit_normal"], 1, 1) == glm::vec4(0.0f, -1.0f, 0.0f, 1.0f));
}
