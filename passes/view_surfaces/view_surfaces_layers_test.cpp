// Blended surfaces by layers.
#include <algorithm>
#include <vector>

#include "passes/view_surfaces/view_surfaces.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Of a layer of blended squares at these heights, 10 m under the camera: a pixel's depth and alpha. `behind`,
// `before`: depths of what is opaque and of the layer before, 0: none; `glass`: the height of glass, 0: none.
struct LayerBench {
  std::vector<float> heights;
  float alpha = 0.25f, behind = 0.0f, before = 0.0f, glass = 0.0f;
  SurfaceRole role{.role = Role::Blended, .blended = true};
  AlphaMode mode = AlphaMode::Blend;
  glm::vec3 color{1.0f};
  float transmission = 0.0f;

  PassImages layer(int number) const {
    const Pass pass = view_surfaces_pass();
    const auto is_layer = [&](const DrawnFor& each) { return each.layer == number; };
    const DrawnFor& drawn_for = *std::find_if(pass.drawn_for.begin(), pass.drawn_for.end(), is_layer);
    Material material;
    material.metallic = 0.0f;
    material.alpha_mode = mode;
    material.base_color = glm::vec4(color, alpha);
    material.transmission = transmission;
    material.double_sided = true;
    MeshData mesh = level(heights[0]);
    for (std::size_t i = 1; i < heights.size(); ++i) mesh = both(mesh, level(heights[i]));
    const View view = down(2.0, 10.0, 20.0);
    Effects effects;
    effects.surfaces = {role};
    return run_pass(
        definition_of(pass, {}, drawn_for),
        {.uniforms = pass.uniforms(
             {.effects = &effects, .camera = &view, .material = &material, .drawn_for = &drawn_for}),
         .textures = {Image{}, Image{}, Image{}, Image{}, Image{}, Image{}, Image{}, Image{}, Image{},
                      Image{}, filled(1, 1, {0, 1, 0, behind}), filled(1, 1, {0, 1, 0, before}),
                      filled(1, 1, {0, glass, 0, glass > 0.0f ? 1.0f : 0.0f})},
         .mesh = mesh});
  }
  float depth(int number) const { return layer(number)["view_normal"].at(0, 0, 3); }
};

}  // namespace

TEST_CASE("view_surfaces: layers are blended surfaces from the nearest on, whatever their order") {
  for (const std::vector<float>& heights : {std::vector{1.0f, 4.0f, 2.0f}, std::vector{4.0f, 2.0f, 1.0f}}) {
    LayerBench bench{heights};
    CHECK(bench.depth(1) == 6.0f);
    CHECK(bench.layer(1)["view_albedo"].at(0, 0, 3) == 0.25f);
    bench.before = 6.0f;
    CHECK(bench.depth(2) == 8.0f);
    bench.before = 8.0f;
    CHECK(bench.depth(3) == 9.0f);
    bench.before = 9.0f;
    CHECK(bench.layer(4)["view_position"].at(0, 0, 3) == 0.0f);
    bench.before = 0.0f;  // where a layer is empty the next is too
    CHECK(bench.layer(2)["view_position"].at(0, 0, 3) == 0.0f);
  }
}

TEST_CASE("view_surfaces: a layer leaves out what is hidden, opaque or not there") {
  CHECK(LayerBench{{4.0f}, 0.25f, 7.0f}.depth(1) == 6.0f);
  CHECK(LayerBench{{4.0f}, 0.25f, 5.0f}.depth(1) == 0.0f);
  CHECK(LayerBench{{4.0f}, 1.0f}.depth(1) == 0.0f);
  CHECK(LayerBench{{4.0f}, 0.0f}.depth(1) == 0.0f);
}

TEST_CASE(
    "view_surfaces: of glass that lets a share through the rest is a layer on it, before what lies behind") {
  LayerBench bench{{4.0f}};
  bench.role = {.role = Role::Refractor, .partly_diffuse = true};
  bench.mode = AlphaMode::Opaque;
  bench.color = {0.8f, 0.4f, 0.2f};
  bench.transmission = 0.75f;
  bench.glass = 4.0f;
  const PassImages out = bench.layer(1);
  CHECK(out["view_position"].at(0, 0, 3) == 3.0f);
  // Of index 1.5 a face leaves 0.96.
  CHECK(out["view_albedo"].at(0, 0, 0) == Approx(0.8 * 0.96).epsilon(1e-5));
  CHECK(out["view_albedo"].at(0, 0, 3) == 0.25f);
  CHECK(out["view_specular"].at(0, 0, 0) == 0.0f);
}

TEST_CASE("view_surfaces: a pane's layer scatters what its two faces leave of the light") {
  LayerBench bench{{4.0f}};
  bench.role = {.role = Role::ThinPane, .partly_diffuse = true};
  bench.mode = AlphaMode::Opaque;
  bench.color = {0.8f, 0.4f, 0.2f};
  bench.transmission = 0.4f;
  bench.glass = 4.0f;
  const Image albedo = bench.layer(1)["view_albedo"];
  CHECK(albedo.at(0, 0, 3) == Approx(0.6));
  for (int c = 0; c < 3; ++c) CHECK(albedo.at(0, 0, c) == Approx(bench.color[c] * 0.96 / 1.04).epsilon(1e-5));
  // Where only half of it is there, it has the same colour.
  bench.mode = AlphaMode::Blend;
  bench.alpha = 0.5f;
  const Image half = bench.layer(1)["view_albedo"];
  CHECK(half.at(0, 0, 3) == Approx(0.3));
  CHECK(half.at(0, 0, 1) == Approx(0.4 * 0.96 / 1.04).epsilon(1e-5));
}

TEST_CASE("view_surfaces: layers before glass are marked, and those behind it left out with them") {
  LayerBench bench{{4.0f, 1.0f}};
  bench.glass = 2.0f;
  CHECK(bench.layer(1)["view_position"].at(0, 0, 3) == 2.0f);
  bench.before = 6.0f;
  CHECK(bench.depth(2) == 0.0f);
  bench.glass = 5.0f;
  CHECK(bench.layer(1)["view_position"].at(0, 0, 3) == 1.0f);
  CHECK(bench.depth(2) == 9.0f);
}
