#include "passes/shadow_bounds/shadow_bounds.hpp"

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/hazy_room.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// All three maps count. The view looks down from 10 m.
PassImages bounds_of_maps(const Image& depths, const Image& casters, const Image& tints) {
  const Scene scene = hazy_room();
  Effects effects;
  effects.occluders.active = effects.tinted_light.active = effects.caustics.active = true;
  effects.expectations = {{.light = 0, .expected = true}};
  LightViews views;
  views.caster = down(1.0, 10.0, 20.0);
  const Pass pass = shadow_bounds_pass();
  const Settings settings;
  const TargetSize size = pass.size(settings, effects, nullptr);
  return run_pass(definition_of(pass), {.width = size.width,
                                        .height = size.height,
                                        .uniforms = pass.uniforms({.scene = &scene,
                                                                   .settings = &settings,
                                                                   .effects = &effects,
                                                                   .views = &views,
                                                                   .light = &scene.lights[0],
                                                                   .width = size.width,
                                                                   .height = size.height}),
                                        .textures = {depths, casters, tints}});
}

}  // namespace

TEST_CASE("shadow_bounds: a block has the least and the largest depth of its texels") {
  // Two by two texels a block: texel (37, 90) lies in block (18, 45).
  Image depths = filled(128, 128, glm::vec4(5.0f));
  depths.at(37, 90, 0) = 2.0f;
  const PassImages out =
      bounds_of_maps(depths, filled(64, 64, glm::vec4(0.0f)), filled(8, 8, glm::vec4(1.0f)));
  CHECK(glm::vec2(texel(out["shadow_bounds"], 18, 45)) == glm::vec2(2.0f, 5.0f));
  for (const glm::ivec2 beside : {glm::ivec2(17, 45), {19, 45}, {18, 44}, {18, 46}, {0, 0}, {63, 63}})
    CHECK(glm::vec2(texel(out["shadow_bounds"], beside.x, beside.y)) == glm::vec2(5.0f, 5.0f));
}

TEST_CASE(
    "shadow_bounds: where sides are no multiple of each other, a block counts each texel that it cuts") {
  // 100 texels, 64 blocks: texel 50 reaches from 32 to 32.64 blocks, texel 49 from 31.36 to 32.
  Image depths = filled(100, 100, glm::vec4(5.0f));
  depths.at(50, 49, 0) = 7.0f;
  const PassImages out =
      bounds_of_maps(depths, filled(64, 64, glm::vec4(0.0f)), filled(8, 8, glm::vec4(1.0f)));
  CHECK(out["shadow_bounds"].at(32, 31, 1) == 7.0f);
  for (const glm::ivec2 beside : {glm::ivec2(31, 31), {33, 31}, {32, 30}, {32, 32}})
    CHECK(out["shadow_bounds"].at(beside.x, beside.y, 1) == 5.0f);
}

TEST_CASE("shadow_bounds: casters have a depth along the light, and none where they do not cover a texel") {
  // A texel a block; the caster's surface is at height 4, 6 m below the light.
  Image casters = filled(64, 64, glm::vec4(0.0f));
  casters.at(10, 20, 1) = 4.0f;
  casters.at(10, 20, 3) = 1.0f;
  const PassImages out =
      bounds_of_maps(filled(8, 8, glm::vec4(5.0f)), casters, filled(8, 8, glm::vec4(1.0f)));
  CHECK(glm::vec2(texel(out["caster_bounds"], 10, 20)) == glm::vec2(6.0f, 6.0f));
  CHECK(glm::vec2(texel(out["caster_bounds"], 11, 20)) == glm::vec2(1e30f, 1e30f));
}

TEST_CASE("shadow_bounds: panes spread by the channel that differs most, as far as interpolation reaches") {
  Image tints = filled(64, 64, glm::vec4(0.75f));
  tints.at(30, 30, 1) = 0.25f;
  const PassImages out =
      bounds_of_maps(filled(8, 8, glm::vec4(5.0f)), filled(64, 64, glm::vec4(0.0f)), tints);
  for (const glm::ivec2 near : {glm::ivec2(30, 30), {29, 30}, {31, 31}})
    CHECK(out["pane_bounds"].at(near.x, near.y, 1) == 0.5f);
  CHECK(out["pane_bounds"].at(34, 30, 1) == 0.0f);
  CHECK(out["pane_bounds"].at(26, 30, 1) == 0.0f);
}
