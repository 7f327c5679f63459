#include "passes/hidden_ends/hidden_ends.hpp"

#include <vector>

#include "pipeline/scene/cube_view.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A square of 10 m at this height, which faces up or down.
Mesh face(float height, bool up) {
  const glm::vec3 a(-5.0f, height, 5.0f), b(5.0f, height, 5.0f), c(5.0f, height, -5.0f),
      d(-5.0f, height, -5.0f);
  std::vector<Corners> triangles;
  for (const Corners& corners : {Corners{a, b, c}, Corners{a, c, d}})
    triangles.push_back(up ? corners : Corners{corners[0], corners[2], corners[1]});
  return mesh_of(triangles);
}

// A camera 10 m up looks straight down, in 4 x 4 pixels, on a sheet of metal or of index 1 at height 5, with
// a floor below it at height 0 and a ceiling above the camera at 12.
struct Bench {
  bool mirror = false;
  bool in_picture = false;  // the floor is
  glm::vec4 fade{0.0f};     // its centre and where it begins
  float fade_to = 0.0f;
  bool ceiling_faces_up = false;
  bool one_sided = false;       // the ceiling is not seen from behind
  std::vector<float> sheets{};  // heights of surfaces of opacity 0.5
  float drawn_from = 0.0f;

  PassImages run(bool mirrored) const {
    const View view = down(4.0, 10.0, 20.0);
    HierarchyBench hierarchy;
    hierarchy.touch = 1e-4f;
    hierarchy.caster(face(5.0f, true))
        .receiver(face(0.0f, true), 1)
        .receiver(face(12.0f, ceiling_faces_up), 2);
    for (const float height : sheets) hierarchy.sheet(face(height, true), 3);
    const HierarchyTables tables = hierarchy.tables();
    Image materials(Format::RGBA32F, 4, 4);
    const auto put = [&](int row, int column, const glm::vec4& texel) {
      for (int c = 0; c < 4; ++c) materials.at(column, row, c) = texel[c];
    };
    put(0, 0, {1.0f, 0.0f, 0.0f, mirror ? 1.0f : 0.0f});
    put(0, 2, {1.0f, 1.0f, 1.0f, 0.0f});
    put(0, 3, {1.0f, 0.0f, 0.0f, 0.0f});
    put(1, 0, {5.0f, 6.0f, 7.0f, 0.0f});
    put(1, 1, fade);
    put(1, 2, {0.25f, 0.5f, 0.75f, fade_to});
    put(2, 0, {0.0f, 0.0f, 0.0f, one_sided ? 1.0f : 0.0f});
    put(2, 2, {0.125f, 0.0f, 0.0f, 0.0f});
    put(3, 2, {0.375f, 0.0f, 0.0f, 0.0f});
    put(3, 3, {2.0f, 0.0f, 0.5f, kCoversAll});
    const std140::HiddenEnds u{.view = shader_view(view),
                               .eye = view.origin,
                               .surfaces = 4,
                               .forward = view.forward,
                               .most_surfaces = 4,
                               .bend = 0.0f,
                               .most_steps = 1000,
                               .first_receiver = hierarchy.first_receiver(),
                               .touch = hierarchy.touch,
                               .first_uv = 0,
                               .rough_from = 0.2f,
                               .has_textures = 0,
                               .has_rough = 0,
                               .has_walls = 0,
                               .has_sheets = !sheets.empty(),
                               .drawn_from = drawn_from,
                               .mirrors = mirrored};
    const auto level = [&](float height) { return filled(1, 1, {-0.5f, height, -0.25f, 1.0f}); };
    return run_pass(
        definition_of(hidden_ends_pass(), {}, mirrored ? kHiddenMirrored : kHiddenBehind),
        {.uniforms = uniform_bytes(u),
         .textures = {in_picture ? level(0.0f) : Image{}, filled(1, 1, {-0.5f, 5.0f, -0.25f, 3.0f}),
                      filled(1, 1, {0.0f, 1.0f, 0.0f, 0.0f}), materials, tables.nodes, tables.triangles,
                      tables.normals, Image{}}});
  }
};

}  // namespace

TEST_CASE("hidden_ends: behind glass the floor that the picture does not show, with its colour and light") {
  const PassImages out = Bench{}.run(false);
  CHECK(texel(out["view_position"], 0, 0) == glm::vec4(-0.5f, 0.0f, -0.25f, 1.0f));
  CHECK(glm::vec3(texel(out["view_normal"], 0, 0)) == glm::vec3(0.0f, 1.0f, 0.0f));
  CHECK(texel(out["view_albedo"], 0, 0) == glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
  CHECK(glm::vec3(texel(out["view_emission"], 0, 0)) == glm::vec3(5.0f, 6.0f, 7.0f));
}

TEST_CASE("hidden_ends: nothing where the picture shows it, nor where there is no second way") {
  Bench bench;
  bench.in_picture = true;
  CHECK(bench.run(false)["view_position"].at(0, 0, 3) == 0.0f);
  bench.in_picture = false;
  bench.mirror = true;
  CHECK(bench.run(false)["view_position"].at(0, 0, 3) == 0.0f);
}

TEST_CASE("hidden_ends: metal mirrors the ceiling behind the camera, on the side that it is seen from") {
  Bench bench;
  bench.mirror = true;
  const PassImages out = bench.run(true);
  CHECK(texel(out["view_position"], 0, 0) == glm::vec4(-0.5f, 12.0f, -0.25f, 1.0f));
  CHECK(glm::vec3(texel(out["view_normal"], 0, 0)) == glm::vec3(0.0f, -1.0f, 0.0f));
  CHECK(out["view_albedo"].at(0, 0, 0) == 0.125f);
}

TEST_CASE("hidden_ends: an added ground fades") {
  Bench bench;
  // 1 m from (-1.5, 0, -0.25), a quarter of the way from 0.5 to 2.5: 1 - 3 / 16 + 2 / 64.
  bench.fade = {-1.5f, 0.0f, -0.25f, 0.5f};
  bench.fade_to = 2.5f;
  CHECK(bench.run(false)["view_albedo"].at(0, 0, 3) == Approx(0.84375));
}

TEST_CASE("hidden_ends: what is not seen from behind is passed there") {
  Bench bench;
  bench.mirror = bench.one_sided = true;
  CHECK(bench.run(true)["view_position"].at(0, 0, 3) == 1.0f);
  bench.ceiling_faces_up = true;
  CHECK(bench.run(true)["view_position"].at(0, 0, 3) == 0.0f);
  bench.one_sided = false;
  CHECK(bench.run(true)["view_position"].at(0, 0, 3) == 1.0f);
}

TEST_CASE(
    "hidden_ends: a blended surface before what the picture shows, and one of both where it shows neither") {
  Bench bench;
  bench.sheets = {2.0f};
  bench.in_picture = true;
  bench.drawn_from = 0.75f;
  const glm::vec4 sheet(-0.5f, 2.0f, -0.25f, 2.0f);
  const PassImages out = bench.run(false);
  CHECK(texel(out["view_position"], 0, 0) == sheet);
  CHECK(texel(out["view_albedo"], 0, 0) == glm::vec4(0.375f, 0.0f, 0.0f, 1.0f));
  bench.in_picture = false;
  const glm::vec4 floor = texel(bench.run(false)["view_position"], 0, 0);
  CHECK(floor.y == Approx(0.0).margin(1e-6));
  CHECK(floor.w == 1.0f);
  bench.drawn_from = 0.25f;
  CHECK(texel(bench.run(false)["view_position"], 0, 0) == sheet);
}

TEST_CASE("hidden_ends: of two blended surfaces each is shown as often as it is seen") {
  // The nearer keeps 0.5, the farther 0.25.
  Bench bench;
  bench.sheets = {2.0f, 3.0f};
  bench.in_picture = true;
  int nearer = 0;
  for (int i = 0; i < 30; ++i) {
    bench.drawn_from = static_cast<float>(i) / 30.0f;
    nearer += bench.run(false)["view_position"].at(0, 0, 1) == 3.0f ? 1 : 0;
  }
  CHECK(nearer == 20);
}
