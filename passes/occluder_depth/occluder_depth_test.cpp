#include "passes/occluder_depth/occluder_depth.hpp"

#include "passes/receiver_map/receiver_map.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("occluder_depth: the depth of the nearest opaque surface is left for the casters to be tested by") {
  // A level square of 1 m at height 1, seen from 4 m up with depths from 0 to 8 m: 3 / 8 in the middle 4 x 4
  // texels.
  const glm::vec3 corners[4] = {{-0.5, 1, 0.5}, {0.5, 1, 0.5}, {0.5, 1, -0.5}, {-0.5, 1, -0.5}};
  const PassImages out =
      run_pass(definition_of(occluder_depth_pass()),
               {.width = 8,
                .height = 8,
                .uniforms = uniform_bytes(receiver_map_uniforms(down(1.0, 4.0, 8.0), Material{})),
                .textures = {Image{}},
                .mesh = quad(corners, {0.0f, 1.0f, 0.0f})});
  CHECK(out["caster_depth"].at(3, 3, 0) == 0.375f);
  CHECK(out["caster_depth"].at(1, 3, 0) == 1.0f);
}
