#include "passes/first_hit/first_hit.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

const glm::vec4 kNone{0.0f};

// A camera 10 m up that looks down: a floor at height 0 and depth 10, lit, perhaps glass before it.
struct Bench {
  int size = 1;
  glm::vec4 position{0.0f, 0.0f, 0.0f, 1.0f}, normal{0.0f, 1.0f, 0.0f, 10.0f};
  glm::vec4 caster{0.0f}, caster_normal{0.0f};
  bool lights = true, casters = true;

  PassImages run() const {
    const View view = down(1.0, 10.0, 20.0);
    const Pass pass = first_hit_pass();
    const auto all = [&](const glm::vec4& value) { return filled(size, size, value); };
    return run_pass(
        definition_of(pass),
        {.width = size,
         .height = size,
         .uniforms = pass.uniforms({.camera = &view}),
         .textures = {all(position), all(normal), lights ? all({100.0f, 50.0f, 25.0f, 0.0f}) : Image{},
                      lights ? all({10.0f, 20.0f, 30.0f, 0.0f}) : Image{}, casters ? all(caster) : Image{},
                      casters ? all(caster_normal) : Image{}}});
  }
};

}  // namespace

TEST_CASE("first_hit: without glass the layers are the opaque surface's") {
  const Bench bench;
  const PassImages out = bench.run();
  CHECK(texel(out["aov_direct"], 0, 0) == glm::vec4(100.0f, 50.0f, 25.0f, 0.0f));
  CHECK(texel(out["aov_caustic"], 0, 0) == glm::vec4(10.0f, 20.0f, 30.0f, 0.0f));
  CHECK(texel(out["aov_position"], 0, 0) == bench.position);
  CHECK(texel(out["aov_normal"], 0, 0) == bench.normal);
}

TEST_CASE("first_hit: a nearer caster is what the pixel hits, and it has no irradiance") {
  Bench bench;
  bench.caster = {0.5f, 4.0f, 0.25f, 1.0f};
  bench.caster_normal = {0.0f, 0.6f, 0.8f, 2.0f};
  const PassImages out = bench.run();
  CHECK(texel(out["aov_direct"], 0, 0) == kNone);
  CHECK(texel(out["aov_caustic"], 0, 0) == kNone);
  CHECK(texel(out["aov_position"], 0, 0) == bench.caster);
  // The depth is 10 - 4, not the material's row.
  CHECK(texel(out["aov_normal"], 0, 0) == glm::vec4(0.0f, 0.6f, 0.8f, 6.0f));
}

TEST_CASE("first_hit: a caster seen from inside shows its normal turned round, its coverage is 1") {
  Bench bench;
  bench.caster = {0.0f, 4.0f, 0.0f, -1.0f};
  bench.caster_normal = {0.0f, -1.0f, 0.0f, 2.0f};
  const PassImages out = bench.run();
  CHECK(texel(out["aov_position"], 0, 0) == glm::vec4(0.0f, 4.0f, 0.0f, 1.0f));
  CHECK(texel(out["aov_normal"], 0, 0) == glm::vec4(0.0f, 1.0f, 0.0f, 6.0f));
}

TEST_CASE("first_hit: a caster behind the surface is hidden, one before the open sky is not") {
  Bench bench;
  bench.caster = {0.0f, -4.0f, 0.0f, 1.0f};
  bench.caster_normal = {0.0f, 1.0f, 0.0f, 0.0f};
  CHECK(texel(bench.run()["aov_position"], 0, 0) == bench.position);
  CHECK(bench.run()["aov_direct"].at(0, 0, 0) == 100.0f);
  bench.position = bench.normal = kNone;
  CHECK(texel(bench.run()["aov_position"], 0, 0) == bench.caster);
  CHECK(bench.run()["aov_normal"].at(0, 0, 3) == 14.0f);
}

TEST_CASE("first_hit: where there is neither surface nor caster position and normal are 0") {
  Bench bench;
  bench.position = bench.normal = kNone;
  CHECK(texel(bench.run()["aov_position"], 0, 0) == kNone);
  CHECK(texel(bench.run()["aov_normal"], 0, 0) == kNone);
}

TEST_CASE("first_hit: a scene without lights and casters has dark layers in every pixel") {
  Bench bench;
  bench.size = 8;
  bench.lights = bench.casters = false;
  const PassImages out = bench.run();
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      CHECK(texel(out["aov_direct"], x, y) == kNone);
      CHECK(texel(out["aov_caustic"], x, y) == kNone);
      CHECK(texel(out["aov_position"], x, y) == bench.position);
    }
}
