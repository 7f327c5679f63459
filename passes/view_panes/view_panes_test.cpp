#include "passes/view_panes/view_panes.hpp"

#include "tests/support/panes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

const Pass kPass = view_panes_pass();
const DrawnFor &kTinted = kPass.drawn_for[0], &kMirrored = kPass.drawn_for[1], &kLit = kPass.drawn_for[2];

// A camera 10 m up that looks down on a level pane at height 4, over a picture of radiance 1.
struct ViewBench {
  Material material = pane_material();
  Scene scene;
  glm::vec4 surface{0.0f}, caster{0.0f};
  float depth = 0.0f;

  glm::vec3 after(const DrawnFor& drawn_for) const {
    const Pass pass = view_panes_pass();
    const View view = down(1.0, 10.0, 20.0);
    LightViews views;
    views.shadow.forward = {0.0, -1.0, 0.0};
    Light sun;
    sun.intensity = 100.0f;
    const bool lit = drawn_for.label == "lit";
    PassDefinition definition = definition_of(pass, {}, drawn_for);
    definition.writes[0].clear = {1.0f, 1.0f, 1.0f, 1.0f};
    return glm::vec3(texel(
        run_pass(definition, {.uniforms = pass.uniforms({.scene = &scene,
                                                         .views = lit ? &views : nullptr,
                                                         .camera = &view,
                                                         .light = lit ? &sun : nullptr,
                                                         .material = &material,
                                                         .drawn_for = &drawn_for}),
                              .textures = {Image{}, filled(1, 1, surface), filled(1, 1, {0, 1, 0, depth}),
                                           filled(1, 1, caster), Image{}},
                              .mesh = level(4.0f)})["beauty"],
        0, 0));
  }
};

}  // namespace

TEST_CASE("view_panes: what lies behind a pane is tinted, before it stays") {
  ViewBench bench;
  check_color(bench.after(kTinted), kPasses * glm::vec3(1.0f, 0.5f, 0.25f));
  bench.surface.w = 1.0f;
  bench.depth = 10.0f;  // on the ground
  check_color(bench.after(kTinted), kPasses * glm::vec3(1.0f, 0.5f, 0.25f));
  bench.depth = 5.0f;  // at height 5
  check_color(bench.after(kTinted), glm::vec3(1.0f));
  bench.depth = 10.0f;
  bench.caster = {0.0f, 5.0f, 0.0f, 1.0f};
  check_color(bench.after(kTinted), glm::vec3(1.0f));
}

TEST_CASE("view_panes: a level pane mirrors the zenith on top of what is seen") {
  ViewBench bench;
  bench.scene.environment.zenith = {10.0f, 20.0f, 30.0f};
  bench.scene.environment.horizon = bench.scene.environment.ground = glm::vec3(1.0f);
  check_color(bench.after(kMirrored), glm::vec3(1.0f) + kMirrors * glm::vec3(10.0f, 20.0f, 30.0f));
}

TEST_CASE("view_panes: a level pane mirrors a soft box overhead, and the sky beside it") {
  ViewBench bench;
  bench.scene.environment.zenith = glm::vec3(1.0f);
  bench.scene.environment.boxes_mean = 1.0f;
  SoftBox& box = bench.scene.environment.boxes[0];
  box = {.half_width = 0.1, .half_height = 0.1, .radiance = 10.0f};
  check_color(bench.after(kMirrored), glm::vec3(1.0f) + kMirrors * glm::vec3(11.0f));
  // Halfway through its soft edge, from 0.7 of the half side on: half its radiance.
  box.middle = glm::normalize(glm::dvec3(0.085, 1.0, 0.0));
  box.across = glm::normalize(glm::dvec3(1.0, -0.085, 0.0));
  check_color(bench.after(kMirrored), glm::vec3(1.0f) + kMirrors * glm::vec3(6.0f));
  box.middle = {0.0, -1.0, 0.0};
  box.across = {1.0, 0.0, 0.0};
  check_color(bench.after(kMirrored), glm::vec3(1.0f) + kMirrors);
}

TEST_CASE("view_panes: a level pane mirrors a light overhead by glTF's lobe, on top of what is seen") {
  // Roughness 0.5: 1 / (4 pi 0.0625) of 100 lux.
  ViewBench bench;
  bench.material.roughness = 0.5f;
  check_color(bench.after(kLit), glm::vec3(1.0f + kMirrors * 100.0f * 4.0f / 3.14159265f));
}
