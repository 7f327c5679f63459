#include "passes/caster_exit_map/caster_exit_map.hpp"

#include "tests/support/caster_bench.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("caster_exit_map: only back faces are drawn") {
  CHECK(seen_by_light(caster_exit_map_pass(), kFront)["caster_exit_position"].at(3, 3, 3) == 0.0f);
  const PassImages out = seen_by_light(caster_exit_map_pass(), kBack);
  CHECK(out["caster_exit_position"].at(3, 3, 3) == 1.0f);
  CHECK(texel(out["caster_exit_normal"], 3, 3) == glm::vec4(0.0f, 1.0f, 0.0f, 1.0f));
}

TEST_CASE("caster_exit_map: of the camera, only back faces are seen") {
  const glm::vec3 up[4] = {{-1, 2, 1}, {1, 2, 1}, {1, 2, -1}, {-1, 2, -1}};
  const glm::vec3 under[4] = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
  CHECK(texel(seen_by_camera(caster_exit_map_pass(), quad(up, {0, 1, 0}))["caster_exit_position"], 1, 1) ==
        glm::vec4(0.0f));
  const PassImages back = seen_by_camera(caster_exit_map_pass(), quad(under, {0, -1, 0}));
  CHECK(texel(back["caster_exit_position"], 1, 1) == glm::vec4(-0.25f, 1.0f, 0.25f, 1.0f));
  CHECK(texel(back["caster_exit_normal"], 1, 1) == glm::vec4(0.0f, -1.0f, 0.0f, 1.0f));
}
