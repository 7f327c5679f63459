#include "passes/haze/haze.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("haze: what the medium scatters is added to the picture's colours, and to them alone") {
  PassDefinition definition = definition_of(haze_pass());
  definition.writes[0].clear = {0.5f, 0.5f, 0.5f, 1.0f};
  const PassImages out = run_pass(definition, {.textures = {filled(1, 1, {1.0f, 2.0f, 4.0f, 8.0f})}});
  CHECK(texel(out["beauty"], 0, 0) == glm::vec4(1.5f, 2.5f, 4.5f, 1.0f));
}
