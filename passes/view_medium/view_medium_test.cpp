#include "passes/view_medium/view_medium.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/hazy_room.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A camera 10 m up looks straight down, at the floor or at nothing, through the haze below 4 m.
PassImages look(const glm::vec4& surface, float depth) {
  const Scene scene = hazy_room();
  const View view = down(1.0, 10.0, 20.0);
  const Pass pass = view_medium_pass();
  PassDefinition definition = definition_of(pass);
  definition.writes[0].clear = {1.0f, 1.0f, 1.0f, 1.0f};
  return run_pass(definition,
                  {.uniforms = pass.uniforms({.scene = &scene, .camera = &view, .width = 1, .height = 1}),
                   .textures = {filled(1, 1, surface), filled(1, 1, {0.0f, 1.0f, 0.0f, depth}), Image{}}});
}

}  // namespace

TEST_CASE("view_medium: the picture loses what the haze takes on the way through it (Beer and Lambert)") {
  const PassImages out = look({0.0f, 0.0f, 0.0f, 1.0f}, 10.0f);
  for (int c = 0; c < 3; ++c)
    CHECK(out["beauty"].at(0, 0, c) == Approx(std::exp(-kHaze * kHeight)).epsilon(1e-6));
  CHECK(texel(out["view_range"], 0, 0) == glm::vec4(10.0f, 6.0f, 10.0f, 0.0f));
}

TEST_CASE("view_medium: a surface before the haze loses nothing") {
  const PassImages out = look({0.0f, 5.0f, 0.0f, 1.0f}, 5.0f);
  CHECK(out["beauty"].at(0, 0, 0) == 1.0f);
  CHECK(texel(out["view_range"], 0, 0) == glm::vec4(5.0f, 0.0f, 0.0f, 0.0f));
}
