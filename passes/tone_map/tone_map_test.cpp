#include "passes/tone_map/tone_map.hpp"

#include <cmath>
#include <limits>

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Display levels, 0 to 255, of one pixel of this radiance.
glm::ivec4 shown(const glm::vec4& radiance, float exposure = 1.0f, const Settings& settings = {},
                 float contrast = 1.0f) {
  const Pass pass = tone_map_pass();
  const Image picture = run_pass(
      definition_of(pass),
      {.uniforms = pass.uniforms({.settings = &settings, .exposure = exposure, .contrast = contrast}),
       .textures = {filled(1, 1, radiance)}})["picture"];
  return glm::ivec4(glm::round(texel(picture, 0, 0) * 255.0f));
}

}  // namespace

TEST_CASE("tone_map: black stays black") {
  CHECK(shown({0.0f, 0.0f, 0.0f, 1.0f}) == glm::ivec4(0, 0, 0, 255));
}

TEST_CASE("tone_map: a mid grey loses the curve's offset and takes the sRGB curve") {
  // 0.5 - 0.04 = 0.46, below the shoulder at 0.76; 1.055 * 0.46^(1 / 2.4) - 0.055 = 0.70837, 180.6 of 255.
  CHECK(shown(glm::vec4(0.5f)) == glm::ivec4(181, 181, 181, 255));
}

TEST_CASE("tone_map: below 0.08 the offset grows with the value") {
  // 0.04: the offset is 0.04 - 6.25 * 0.04^2 = 0.03; 0.01 encodes to 1.055 * 0.14678 - 0.055 = 0.09985.
  CHECK(shown(glm::vec4(0.04f)).x == 25);
  // 0.01: 0.000625 is left, on the straight part of the sRGB curve: 12.92 * 0.000625 * 255 = 2.06.
  CHECK(shown(glm::vec4(0.01f)).x == 2);
}

TEST_CASE("tone_map: the exposure is a factor on the radiance") {
  CHECK(shown(glm::vec4(0.25f), 2.0f) == shown(glm::vec4(0.5f)));
  CHECK(shown(glm::vec4(5000.0f), 1e-4f) == shown(glm::vec4(0.5f)));
}

TEST_CASE(
    "tone_map: contrast is a power about 0.31 that keeps channels in proportion, in the dark a weak one") {
  CHECK(shown(glm::vec4(0.31f), 1.0f, {}, 2.0f) == shown(glm::vec4(0.31f)));
  // 0.465: 0.465^2 / 0.31 = 0.6975; at the contrast 3: 0.34875 * 1.125^2 = 0.44139.
  CHECK(shown(glm::vec4(0.465f), 1.0f, {}, 2.0f) == shown(glm::vec4(0.6975f)));
  CHECK(shown(glm::vec4(0.34875f), 1.0f, {}, 3.0f) == shown(glm::vec4(0.44139f)));
  CHECK(shown({0.465f, 0.31f, 0.0f, 1.0f}, 1.0f, {}, 2.0f) == shown({0.6975f, 0.465f, 0.0f, 1.0f}));
  // A quarter of 0.31, at 1.5: by 0.25^0.25 darker; from the contrast 1.6 on by 0.25^0.3.
  CHECK(shown(glm::vec4(0.31f / 4.0f), 1.0f, {}, 1.5f) == shown(glm::vec4(0.31f / 4.0f * 0.70711f)));
  CHECK(shown(glm::vec4(0.31f / 4.0f), 1.0f, {}, 1.6f) == shown(glm::vec4(0.31f / 4.0f * 0.65975f)));
  CHECK(shown(glm::vec4(0.31f / 4.0f), 1.0f, {}, 6.0f) == shown(glm::vec4(0.31f / 4.0f * 0.65975f)));
  CHECK(shown(glm::vec4(0.0f), 1.0f, {}, 6.0f) == glm::ivec4(0, 0, 0, 255));
  for (const ToneMap plain : {ToneMap::Neutral, ToneMap::Linear}) {
    Settings settings;
    settings.tone_map = plain;
    CHECK(shown(glm::vec4(0.495f), 1.0f, settings, 2.0f) == shown(glm::vec4(0.495f), 1.0f, settings));
  }
}

TEST_CASE("tone_map: the shoulder presses what is brighter towards white") {
  // 1.04 - 0.04 = 1; 1 - 0.24^2 / (1 + 0.24 - 0.76) = 0.88; 1.055 * 0.88^(1 / 2.4) - 0.055 = 0.94528: 241.0.
  CHECK(shown(glm::vec4(1.04f)).x == 241);
  CHECK(shown(glm::vec4(1e5f)) == glm::ivec4(255));
  CHECK(shown(glm::vec4(std::numeric_limits<float>::infinity())) == glm::ivec4(255));
}

TEST_CASE("tone_map: dim colours keep their channels, a very bright one turns white") {
  // The least channel is 0, so there is no offset: 1.055 * 0.2^(1 / 2.4) - 0.055 = 0.48453, 123.6 of 255.
  CHECK(shown({0.2f, 0.0f, 0.0f, 1.0f}) == glm::ivec4(124, 0, 0, 255));
  const glm::ivec4 glaring = shown({1e5f, 0.0f, 0.0f, 1.0f});
  CHECK(glaring.x == 255);
  CHECK(glaring.y > 250);
}

TEST_CASE("tone_map: a bright colour takes the published formula's values") {
  // PBRNeutralToneMapping(2, 1, 0.5): 0.04 off; 1.96 is pressed to 1 - 0.0576 / 1.44 = 0.96, all by its
  // factor 0.48980; a share of 1 - 1 / 1.15 = 0.13043 of 0.96 is white. sRGB of (0.96, 0.53409, 0.32114).
  CHECK(shown({2.0f, 1.0f, 0.5f, 1.0f}) == glm::ivec4(250, 193, 154, 255));
}

TEST_CASE("tone_map: linear cuts off what is brighter than white and takes the sRGB curve") {
  Settings linear;
  linear.tone_map = ToneMap::Linear;
  // 1.055 * 0.5^(1 / 2.4) - 0.055 = 0.73536, 187.5 of 255.
  CHECK(shown({0.5f, 1.0f, 7.0f, 1.0f}, 1.0f, linear) == glm::ivec4(188, 255, 255, 255));
}

TEST_CASE("tone_map: what is not a number, or negative, is shown as black") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(shown({nan, nan, nan, 1.0f}) == glm::ivec4(0, 0, 0, 255));
  CHECK(shown({-1.0f, -2.0f, -3.0f, 1.0f}) == glm::ivec4(0, 0, 0, 255));
  // Beside a channel of 0.46 it counts as 0, so nothing is taken off: 0.46 encodes to 181 as above.
  CHECK(shown({nan, 0.46f, 0.46f, 1.0f}) == glm::ivec4(0, 181, 181, 255));
}
