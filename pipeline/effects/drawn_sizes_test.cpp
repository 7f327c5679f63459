#include "pipeline/effects/drawn_sizes.hpp"

#include "pipeline/effects/dim_lights.hpp"
#include "pipeline/scene/emitter.hpp"
#include "pipeline/scene/light_samples.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A ball over a floor under a sun of 10 lux and 5 degrees, drawn by four samples.
struct Bench {
  Scene scene = sphere_scene(1.5f, 2);
  Settings settings{};

  explicit Bench(LightShape shape = LightShape::Disk) {
    scene.lights.front().shape = shape;
    scene.lights.front().angular_radius = 0.0436;
    scene.lights.front().intensity = 10.0f;
    sample_lights(scene, 4);
  }
  Effects effects() const { return with_drawn_sizes(effects_of(scene, settings), scene, settings); }
};

int expected(const Effects& effects) {
  int count = 0;
  for (const Expectation& e : effects.expectations) count += e.expected ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("drawn sizes: one sample throws the caustic of all, whose direct light the casters shadow") {
  const Effects effects = Bench{}.effects();
  CHECK(effects.lights[0].size_is_drawn);
  CHECK(effects.lights[0].of_others == glm::vec3(7.5f));
  CHECK_FALSE(effects.lights[0].casters_shadow);
  for (std::size_t l = 1; l < 4; ++l) {
    CHECK_FALSE(effects.lights[l].size_is_drawn);
    CHECK(effects.lights[l].casters_shadow);
  }
  for (const Expectation& e : effects.expectations) CHECK(e.expected == (e.light == 0));
  CHECK(all_sizes_are_drawn(effects));
}

TEST_CASE(
    "drawn sizes: the samples of what looks wide have shadow maps of half the side, a sun's have whole "
    "ones") {
  for (const bool wide : {false, true}) {
    Bench bench;
    if (wide) {
      bench.scene = sphere_scene(1.5f, 2);
      Light& lamp = bench.scene.lights.front();
      lamp.type = LightType::Point;
      lamp.position = {0.0, 4.0, 0.0};
      lamp.shape = LightShape::Sphere;
      lamp.radius = 0.5;
      sample_lights(bench.scene, 4);
    }
    const Effects effects = bench.effects();
    const LightSettings settings(bench.settings, effects);
    int drawn = 0;
    for (int l = 0; l < 4; ++l) {
      const bool is_drawn = effects.lights[static_cast<std::size_t>(l)].size_is_drawn;
      drawn += is_drawn ? 1 : 0;
      const bool half = wide && !is_drawn;
      CHECK(settings[l].shadow == (half ? 1024 : 2048));
      CHECK(settings[l].grid == bench.settings.grid);
    }
    CHECK(drawn == 1);
  }
}

TEST_CASE(
    "drawn sizes: where light is not followed, or nothing is to be drawn, each sample has its own caustic") {
  const int each = expected(effects_of(Bench{}.scene, {}));
  Bench bench;
  bench.settings.drawn = false;
  CHECK(expected(bench.effects()) == each);
  bench.settings = {};
  bench.settings.further_share = 1.0f;
  CHECK(expected(bench.effects()) == each);
  bench.settings = {};
  bench.settings.interfaces = Interfaces::Two;
  CHECK(expected(bench.effects()) == each);
  CHECK_FALSE(any_size_is_drawn(bench.effects()));
}

TEST_CASE("drawn sizes: of a sheet that shines to both sides, one sample stands for each side with casters") {
  for (const auto& [double_sided, above] : {std::pair(false, false), {true, false}, {true, true}}) {
    Bench bench;
    bench.scene = sphere_scene(1.5f, 2);
    // And a ball with its receiver on the other side of the sheet.
    if (above) {
      bench.scene.meshes.push_back(sphere({0.0, 4.0, 0.0}, 0.5, 2, 1));
      bench.scene.meshes.push_back(floor(5.0, 6.0, 0));
    }
    Material shining = diffuse(0.5f);
    shining.emissive = glm::vec3(100.0f);
    shining.double_sided = double_sided;
    bench.scene.materials.push_back(shining);
    Mesh sheet = floor(0.5, 2.0, 2);
    if (!double_sided)
      for (std::size_t i = 0; i < sheet.indices.size(); i += 3)
        std::swap(sheet.indices[i], sheet.indices[i + 1]);
    bench.scene.meshes.push_back(sheet);
    bench.scene.lights.clear();
    add_emissive_lights(bench.scene);
    sample_lights(bench.scene, 8);
    const Effects effects = bench.effects();
    int drawn = 0;
    for (std::size_t l = 0; l < effects.lights.size(); ++l) {
      if (!effects.lights[l].size_is_drawn) continue;
      ++drawn;
      if (!above) CHECK(bench.scene.lights[l].direction.y == Approx(-1.0));
      // Each side has 100 candela; the sample's own part is taken off.
      CHECK(effects.lights[l].of_others.x == Approx(double_sided ? 75.0 : 87.5));
    }
    CHECK(drawn == (above ? 2 : 1));
  }
}

namespace {

// A tetrahedron that shines, above the ball and to the left of another: three of its sides look away from the
// first, two from the second.
Bench under_lamp(bool beside) {
  Bench bench;
  bench.scene = sphere_scene(1.5f, 2);
  if (beside) bench.scene.meshes.push_back(sphere({6.0, 3.5, 0.0}, 0.5, 2, 1));
  Material shining = diffuse(0.5f);
  shining.emissive = glm::vec3(100.0f);
  shining.double_sided = false;
  bench.scene.materials.push_back(shining);
  const glm::vec3 a{0.0f, 3.0f, 0.1f}, b{0.1f, 3.0f, -0.1f}, c{-0.1f, 3.0f, -0.1f}, top{0.0f, 4.0f, 0.0f};
  Mesh lamp = mesh_of({{{a, c, b}}, {{a, b, top}}, {{b, c, top}}, {{c, a, top}}});
  lamp.material = 2;
  bench.scene.meshes.push_back(lamp);
  bench.scene.lights.clear();
  add_emissive_lights(bench.scene);
  sample_lights(bench.scene, 16);
  return bench;
}

}  // namespace

TEST_CASE(
    "drawn sizes: of any other mesh that shines one sample that faces the casters stands for all of it") {
  Bench bench = under_lamp(false);
  const float whole = bench.scene.sources.front().intensity;
  const Effects effects = bench.effects();
  int drawn = 0;
  for (std::size_t l = 0; l < effects.lights.size(); ++l) {
    if (!effects.lights[l].size_is_drawn) continue;
    ++drawn;
    CHECK(bench.scene.lights[l].direction.y == Approx(-1.0));
    CHECK(effects.lights[l].of_others.x == Approx(whole * 15.0f / 16.0f));
  }
  CHECK(drawn == 1);
}

TEST_CASE("drawn sizes: a mesh that stands for other lights is brighter by theirs, whichever way it looks") {
  Bench bench = under_lamp(false);
  Effects effects = effects_of(bench.scene, bench.settings);
  for (LightEffects& light : effects.lights) light.of_others = glm::vec3(3.0f);
  effects = with_drawn_sizes(std::move(effects), bench.scene, bench.settings);
  const float whole = bench.scene.sources.front().intensity;
  for (const LightEffects& light : effects.lights)
    if (light.size_is_drawn) CHECK(light.of_others.x == Approx(whole * 15.0f / 16.0f + 16.0f * 3.0f));
  CHECK(any_size_is_drawn(effects));
}

TEST_CASE("drawn sizes: a mesh that shines among its casters has no sample that stands for all of it") {
  const Bench bench = under_lamp(true);
  CHECK_FALSE(any_size_is_drawn(bench.effects()));
  CHECK(expected(bench.effects()) == expected(effects_of(bench.scene, bench.settings)));
}

TEST_CASE("drawn sizes: a light without a size is left as it is") {
  const Effects effects = Bench(LightShape::None).effects();
  CHECK_FALSE(any_size_is_drawn(effects));
  CHECK_FALSE(all_sizes_are_drawn(effects));
  CHECK(expected(effects) > 0);
}
