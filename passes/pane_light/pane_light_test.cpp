#include "passes/pane_light/pane_light.hpp"

#include "tests/support/panes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A light 10 m up that shines straight down through a level pane at height 4.
struct LightBench {
  Material material = pane_material();
  MeshData mesh = level(4.0f);
  bool blended = false;
  float opaque_distance = 1e30f;  // of the nearest opaque surface, from the light

  glm::vec4 transmittance() const {
    LightViews views;
    views.panes = views.shadow = down(1.0, 10.0, 20.0);
    Effects effects;
    effects.occluders.active = true;
    effects.surfaces = {{.blended = blended}};
    const Scene scene;
    const Light light;
    const Pass pass = pane_light_pass();
    return texel(
        run_pass(definition_of(pass), {.uniforms = pass.uniforms({.scene = &scene,
                                                                  .effects = &effects,
                                                                  .views = &views,
                                                                  .light = &light,
                                                                  .material = &material}),
                                       .textures = {Image{}, filled(1, 1, glm::vec4(opaque_distance))},
                                       .mesh = mesh})["pane_transmittance"],
        0, 0);
  }
};

}  // namespace

TEST_CASE("pane_light: a pane passes its colour, less what both faces mirror") {
  check_color(LightBench{}.transmittance(), kPasses * glm::vec3(1.0f, 0.5f, 0.25f));
}

TEST_CASE("pane_light: a pane passes its transmission's share, and all where its alpha leaves it out") {
  LightBench bench;
  bench.material.transmission = 0.4f;
  check_color(bench.transmittance(), 0.4f * kPasses * glm::vec3(1.0f, 0.5f, 0.25f));
  bench.material.alpha_mode = AlphaMode::Blend;
  bench.material.base_color.a = 0.25f;
  check_color(bench.transmittance(), glm::vec3(0.75f) + 0.1f * kPasses * glm::vec3(1.0f, 0.5f, 0.25f));
  // KHR_materials_specular takes what both faces mirror away.
  bench.material = pane_material();
  bench.material.fresnel_factor = 0.0f;
  check_color(bench.transmittance(), glm::vec3(1.0f, 0.5f, 0.25f));
}

TEST_CASE("pane_light: a steep pane passes less") {
  // 60 degrees, sin = 0.8660254, inside cos = sqrt(1 - 0.75 / 2.25) = 0.8164966:
  // rs = ((0.5 - 1.2247449) / 1.7247449)^2 = 0.1765719, rp = ((0.75 - 0.8164966) / 1.5664966)^2 =
  // 0.0018020, r = 0.0891870, (1 - r) / (1 + r) = 0.8362323.
  LightBench bench;
  bench.mesh = quad({{-4, 4, 4}, {4, 4, 4}, {4, 4, -4}, {-4, 4, -4}}, {0.8660254f, 0.5f, 0.0f});
  check_color(bench.transmittance(), 0.8362323f * glm::vec3(1.0f, 0.5f, 0.25f));
}

TEST_CASE("pane_light: two panes multiply") {
  LightBench bench;
  bench.mesh = both(bench.mesh, level(2.0f));
  check_color(bench.transmittance(), kPasses * kPasses * glm::vec3(1.0f, 0.25f, 0.0625f));
}

TEST_CASE("pane_light: a pane behind an opaque surface takes nothing from its light") {
  LightBench bench;
  bench.opaque_distance = 3.0f;  // the pane is 6 m away, two texels' extents are 4 m
  CHECK(bench.transmittance() != glm::vec4(1.0f));
  bench.opaque_distance = 1.5f;
  CHECK(bench.transmittance() == glm::vec4(1.0f));
}

TEST_CASE("pane_light: what an alpha mask cuts out takes nothing") {
  LightBench bench;
  bench.material.alpha_mode = AlphaMode::Mask;
  bench.material.base_color.a = 0.4f;
  CHECK(bench.transmittance() == glm::vec4(1.0f));
}

TEST_CASE("pane_light: blended surfaces pass what they do not cover") {
  LightBench bench;
  bench.blended = true;
  bench.material.alpha_mode = AlphaMode::Blend;
  bench.material.base_color = {0.0f, 0.0f, 0.0f, 0.25f};
  check_color(bench.transmittance(), glm::vec3(0.75f));
  bench.mesh = both(bench.mesh, level(2.0f));
  check_color(bench.transmittance(), glm::vec3(0.5625f));
  bench.material.base_color.a = 1.0f;  // opaque: the shadow map has it
  check_color(bench.transmittance(), glm::vec3(1.0f));
}

TEST_CASE("pane_light: before casters what is nearer than they takes light, a pane by its colour") {
  // The caster is at height 3, the light shines down on a sheet at height 4 or 2.
  const View view = down(1.0, 10.0, 20.0);
  LightViews views;
  views.panes = views.shadow = views.caster = view;
  const Pass pass = pane_light_pass();
  const DrawnFor& casters = pass.drawn_for[1];
  Material material = pane_material();
  material.base_color.a = 0.25f;
  Image casters_seen = filled(1, 1, {0.0f, 3.0f, 0.0f, 1.0f});
  int side = 1;
  const auto reaching = [&](float height, bool blended) {
    Effects effects;
    effects.surfaces = {{.blended = blended}};
    const Scene scene;
    const Light light;
    return texel(
               run_pass(definition_of(pass, {}, casters), {.width = side,
                                                           .height = side,
                                                           .uniforms = pass.uniforms({.scene = &scene,
                                                                                      .effects = &effects,
                                                                                      .views = &views,
                                                                                      .light = &light,
                                                                                      .material = &material,
                                                                                      .drawn_for = &casters}),
                                                           .textures = {Image{}, Image{}, casters_seen},
                                                           .mesh = level(height)})["pane_transmittance"],
               side - 1, side - 1)
        .x;
  };
  CHECK(reaching(4.0f, true) == 0.75f);
  CHECK(reaching(2.0f, true) == 1.0f);
  CHECK(reaching(2.0f, false) == 1.0f);
  CHECK(reaching(4.0f, false) == Approx(material.base_color.x * 0.96 / 1.04));
  casters_seen = filled(1, 1, {0.0f, 3.0f, 0.0f, 0.0f});
  CHECK(reaching(4.0f, true) == 1.0f);
  // A light without a caustic draws no casters.
  casters_seen = Image{};
  side = 64;
  CHECK(reaching(4.0f, true) == 1.0f);
}
