#include "passes/hidden_landings/hidden_landings.hpp"

#include "pipeline/shader/constants.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// One vertex's landing; its other textures have 2, 3, 4, 5 and 6. The farthest receivers lie at a height, in
// a map of 64 texels for 8 m that looks down: eight of its texels are 1 m.
PassImages handed_on(const glm::vec4& landing, float farthest = 0.5f) {
  std::vector<Image> textures{filled(1, 1, landing)};
  for (const float value : {2.0f, 3.0f, 4.0f, 5.0f, 6.0f}) textures.push_back(filled(1, 1, glm::vec4(value)));
  textures.push_back(filled(64, 64, {0.0f, farthest, 0.0f, 1.0f}));
  const std140::HiddenLandings u{.receiver = shader_view(down(4.0, 10.0, 20.0))};
  return run_pass(definition_of(hidden_landings_pass()),
                  {.uniforms = uniform_bytes(u), .textures = textures});
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

TEST_CASE("hidden_landings: grid vertices without light are not shaded") {
  Image landing = filled(40, 3, glm::vec4(0.0f));
  for (const int x : {0, 17, 39}) landing.at(x, 1, 3) = STATUS_NOT_CONVERGED;
  std::vector<Image> textures(6, filled(40, 3, glm::vec4(1.0f)));
  textures[0] = landing;
  textures.push_back(filled(1, 1, {0.0f, 0.0f, 0.0f, 1.0f}));
  const std140::HiddenLandings u{.receiver = shader_view(down(4.0, 10.0, 20.0))};
  const PassImages out =
      run_pass(definition_of(hidden_landings_pass()),
               {.width = 40, .height = 3, .uniforms = uniform_bytes(u), .textures = textures});
  CHECK(out.result.fragments == 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 40; ++x)
      CHECK(out["landing"].at(x, y, 3) == (landing.at(x, y, 3) != 0.0f ? STATUS_LANDED : STATUS_EMPTY));
}

TEST_CASE("hidden_landings: what the map of the farthest receivers does not show either stays lost") {
  const auto status = [](float height, float farthest) {
    return texel(handed_on({1.0f, height, -2.0f, STATUS_NOT_CONVERGED}, farthest)["landing"], 0, 0).w;
  };
  CHECK(status(0.5f, -0.4f) == STATUS_LANDED);
  CHECK(status(0.5f, -0.6f) == STATUS_EMPTY);
  CHECK(status(0.5f, 1.4f) == STATUS_LANDED);
  CHECK(status(0.5f, 1.6f) == STATUS_EMPTY);
}
