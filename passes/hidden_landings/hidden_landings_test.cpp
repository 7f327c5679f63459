#include "passes/hidden_landings/hidden_landings.hpp"

#include "pipeline/shader/constants.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// One vertex's landing; its other textures have 2, 3, 4, 5 and 6.
PassImages handed_on(const glm::vec4& landing) {
  std::vector<Image> textures{filled(1, 1, landing)};
  for (const float value : {2.0f, 3.0f, 4.0f, 5.0f, 6.0f}) textures.push_back(filled(1, 1, glm::vec4(value)));
  return run_pass(definition_of(hidden_landings_pass()), {.textures = textures});
}

}  // namespace

TEST_CASE("hidden_landings: what the light does not see has landed here, with all that is known of it") {
  const PassImages out = handed_on({1.0f, 0.5f, -2.0f, STATUS_NOT_CONVERGED});
  CHECK(texel(out["landing"], 0, 0) == glm::vec4(1.0f, 0.5f, -2.0f, STATUS_LANDED));
  float value = 2.0f;
  for (const char* name :
       {"landing_flux", "landing_fresnel", "landing_absorbed", "landing_path", "landing_footprint"})
    CHECK(texel(out[name], 0, 0) == glm::vec4(value++));
}

TEST_CASE("hidden_landings: what has ended otherwise is not handed on") {
  for (const int status :
       {STATUS_EMPTY, STATUS_LANDED, STATUS_MISSED, STATUS_OUTSIDE, STATUS_ABSORBED, STATUS_GIVEN_UP}) {
    const PassImages out = handed_on({1.0f, 0.5f, -2.0f, static_cast<float>(status)});
    for (const char* name : {"landing", "landing_flux", "landing_path"})
      CHECK(texel(out[name], 0, 0) == glm::vec4(0.0f));
  }
}
