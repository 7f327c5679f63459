#include "passes/average_samples/average_samples.hpp"

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("average_samples: a sample's share of every channel is added to what the samples before left") {
  Settings settings;
  settings.samples = 4;
  const Pass pass = average_samples_pass();
  PassDefinition definition = definition_of(pass);
  definition.writes[0].clear = {0.5f, 0.25f, 3.0f, 0.75f};
  const Image out = run_pass(definition, {.uniforms = pass.uniforms({.settings = &settings}),
                                          .textures = {filled(1, 1, {1.0f, 2.0f, 4.0f, 1.0f})}})["beauty"];
  CHECK(texel(out, 0, 0) == glm::vec4(0.75f, 0.75f, 4.0f, 1.0f));
}
