#include "passes/view_medium/view_medium.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/hazy_room.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// What is left of a white picture where the camera's ray is in the haze from `entry` to `exit`.
float left_of_white(float entry, float exit) {
  const Scene scene = hazy_room();
  const Pass pass = view_medium_pass();
  PassDefinition definition = definition_of(pass);
  definition.writes[0].clear = {1.0f, 1.0f, 1.0f, 1.0f};
  const PassImages out =
      run_pass(definition, {.uniforms = pass.uniforms({.scene = &scene, .width = 1, .height = 1}),
                            .textures = {filled(1, 1, {exit, entry, exit, 0.0f})}});
  for (int c = 1; c < 3; ++c) CHECK(out["beauty"].at(0, 0, c) == out["beauty"].at(0, 0, 0));
  return out["beauty"].at(0, 0, 0);
}

}  // namespace

TEST_CASE("view_medium: the picture loses what the haze takes on the way through it (Beer and Lambert)") {
  CHECK(left_of_white(6.0f, 10.0f) == Approx(std::exp(-kHaze * 4.0)).epsilon(1e-6));
}

TEST_CASE("view_medium: where a ray passes by the haze the picture loses nothing") {
  CHECK(left_of_white(0.0f, 0.0f) == 1.0f);
}
