#include "passes/glass/glass.hpp"

#include <cmath>
#include <optional>

#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A square of 10 m at this height, which faces up or down.
void add_face(std::vector<Corners>& triangles, float height, bool up) {
  const glm::vec3 a(-5.0f, height, 5.0f), b(5.0f, height, 5.0f), c(5.0f, height, -5.0f),
      d(-5.0f, height, -5.0f);
  for (const Corners& corners : {Corners{a, b, c}, Corners{a, c, d}})
    triangles.push_back(up ? corners : Corners{corners[0], corners[2], corners[1]});
}

// A camera 10 m up looks straight down, in 4 x 4 pixels, on plates of glass 1 m thick and a floor at height 0
// that shines with 1 nit. The sky has 0.5 nit everywhere.
struct Bench {
  std::vector<float> tops{5.0f};  // of the plates, the uppermost first
  float ior = 1.5f, absorption = 0.0f;
  bool mirror = false, floor = true;
  int surfaces = 8, most_surfaces = 8;
  bool several_rays = false;
  float roughness = 0.0f;
  bool thin = false;  // a rough wall
  float tint = 1.0f;
  std::vector<float> sheets{};                  // heights of blended surfaces
  float opacity = 0.25f;                        // theirs
  float transmitted = 1.0f;                     // by the plates
  float covers = 1.0f;                          // of blended walls
  bool in_picture = true;                       // the floor is
  float picture_height = 0.0f;                  // of what the picture shows
  bool glass_in_picture = true;                 // the uppermost plate is
  bool eye_in_glass = false;                    // of the plates
  float highlight = 0.0f;                       // nit
  std::optional<float> backdrop;                // seen below the horizon, 0.5 nit without
  glm::vec2 at{-0.5f, -0.25f};                  // x and z of what the pixel shows
  Image shown = filled(1, 1, glm::vec4(1.0f));  // the floor
  Image hidden = filled(1, 1, {0.0f, 0.0f, 0.0f, 1.0f});

  float seen() const {
    const View view = down(4.0, 10.0, 20.0);
    HierarchyBench hierarchy;
    hierarchy.touch = 1e-4f;
    std::vector<Corners> plates, ground;
    for (const float top : tops) {
      add_face(plates, top, true);
      add_face(plates, top - 1.0f, false);
    }
    add_face(ground, 0.0f, true);
    hierarchy.caster(mesh_of(plates));
    if (floor) hierarchy.receiver(mesh_of(ground));
    for (const float height : sheets) {
      std::vector<Corners> sheet;
      add_face(sheet, height, true);
      hierarchy.sheet(mesh_of(sheet), 1);
    }
    const HierarchyTables tables = hierarchy.tables();
    Image materials(Format::RGBA32F, 4, 2);
    materials.at(3, 1, 0) = 2.0f;  // blended
    materials.at(3, 1, 2) = opacity;
    materials.at(3, 1, 3) = kCoversAll;
    const float texels[4][4] = {{ior, 0.0f, 0.0f,
                                 mirror ? 1.0f
                                 : thin ? -1.0f
                                        : 0.0f},
                                {absorption, absorption, absorption, 1.0f},
                                {mirror ? 0.9f : tint, mirror ? 0.9f : tint, mirror ? 0.9f : tint, roughness},
                                {transmitted, 0.0f, covers, covers < 1.0f ? -1.0f : 0.0f}};
    for (int x = 0; x < 4; ++x)
      for (int c = 0; c < 4; ++c) materials.at(x, 0, c) = texels[x][c];
    const glm::vec3 sky(0.5f);
    Environment environment;
    environment.zenith = environment.horizon = environment.ground = sky;
    if (backdrop) environment.backdrop = glm::vec3(*backdrop);
    const std140::Glass u{.sky = shader_sky(environment),
                          .view = shader_view(view),
                          .eye = view.origin,
                          .surfaces = surfaces,
                          .forward = view.forward,
                          .most_surfaces = most_surfaces,
                          .bend = 0.0f,
                          .most_steps = 1000,
                          .first_receiver = hierarchy.first_receiver(),
                          .touch = hierarchy.touch,
                          .first_uv = 0,
                          .rough_from = 0.2f,
                          .eye_media = {eye_in_glass ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f},
                          .has_textures = 0,
                          .has_rough = roughness > 0.0f,
                          .has_walls = thin,
                          .has_sheets = !sheets.empty() || transmitted < 1.0f,
                          .receivers_lower = glm::vec3(-1e4f, -1.0f, -1e4f),
                          .receivers_upper = glm::vec3(1e4f, 1.0f, 1e4f),
                          .blends = 0,
                          .several_rays = several_rays};
    // On the second of the uppermost face's triangles.
    const auto level = [&](float height) { return filled(1, 1, {at.x, height, at.y, 3.0f}); };
    Image floor_position(Format::RGBA32F, shown.width(), 1);
    for (int x = 0; x < shown.width(); ++x)
      for (int c = 0; c < 4; ++c) floor_position.at(x, 0, c) = glm::vec4(at.x, picture_height, at.y, 1.0f)[c];
    const Image beauty = run_pass(
        definition_of(glass_pass()),
        {.uniforms = uniform_bytes(u),
         .textures = {shown, in_picture ? floor_position : Image{}, hidden, hidden,
                      glass_in_picture ? level(tops.front()) : Image{},
                      filled(1, 1, {0.0f, 1.0f, 0.0f, 0.0f}), materials, tables.nodes, tables.triangles,
                      tables.normals, Image{}, filled(1, 1, glm::vec4(highlight))}})["beauty"];
    return beauty.at(0, 0, 0);
  }
};

// What is left of a radiance behind so many surfaces, each of which mirrors 0.04 of the sky's 0.5.
double behind_surfaces(double radiance, int count) {
  for (int i = 0; i < count; ++i) radiance = 0.96 * radiance + 0.04 * 0.5;
  return radiance;
}

}  // namespace

TEST_CASE("glass: a plate shows what lies behind it, and mirrors the sky at both its surfaces") {
  // At both R = ((1.5 - 1) / (1.5 + 1))^2 = 0.04 of the sky's 0.5; the rest of the floor's 1.
  CHECK(Bench{}.seen() == Approx(behind_surfaces(1.0, 2)));
}

TEST_CASE("glass: glass is seen through glass, and each plate absorbs") {
  Bench bench;
  bench.tops = {8.0f, 5.0f, 3.0f};
  bench.absorption = 0.3f;
  double expected = 1.0;
  for (int plate = 0; plate < 3; ++plate)
    expected = behind_surfaces(std::exp(-0.3) * behind_surfaces(expected, 1), 1);
  CHECK(bench.seen() == Approx(expected));
}

TEST_CASE("glass: what stands before it hides it") {
  Bench bench;
  bench.picture_height = 7.0f;
  CHECK(bench.seen() == 1.0f);
}

TEST_CASE("glass: an index of 1 mirrors nothing") {
  Bench bench;
  bench.ior = 1.0f;
  bench.tops = {8.0f, 5.0f};
  CHECK(bench.seen() == Approx(1.0));
}

TEST_CASE("glass: metal mirrors the sky by its reflectance straight on") {
  Bench bench;
  bench.mirror = true;
  CHECK(bench.seen() == Approx(0.9 * 0.5));
}

TEST_CASE("glass: where nothing lies behind, or more surfaces than are followed, there is the sky") {
  Bench bench;
  bench.floor = false;
  CHECK(bench.seen() == Approx(0.5));
  Bench deep;
  deep.tops = {8.0f, 5.0f, 3.0f};
  deep.surfaces = deep.most_surfaces = 3;
  CHECK(deep.seen() == Approx(0.5));
}

TEST_CASE("glass: clear plates over nothing are as bright as the backdrop beside them") {
  Bench bench;
  bench.floor = false;
  bench.tops = {8.0f, 5.0f};
  bench.ior = 1.0f;
  bench.backdrop = 2.0f;
  CHECK(bench.seen() == Approx(2.0));
}

TEST_CASE("glass: blended surfaces behind it cover their share of what lies there") {
  // Hidden rays have found 3 nit of them, over the floor's 1.
  Bench bench;
  bench.ior = 1.0f;
  bench.hidden = filled(1, 1, {3.0f, 3.0f, 3.0f, 0.0f});
  bench.sheets = {2.0f};
  CHECK(bench.seen() == Approx(0.75 + 0.25 * 3.0));
  bench.sheets = {2.0f, 3.0f};
  CHECK(bench.seen() == Approx(0.5625 + 0.4375 * 3.0));
  // Over the sky.
  bench.floor = false;
  CHECK(bench.seen() == Approx(0.5625 * 0.5 + 0.4375 * 3.0));
}

TEST_CASE("glass: blended surfaces use up none of those that are followed") {
  Bench bench;
  bench.ior = 1.0f;
  bench.hidden = filled(1, 1, {3.0f, 3.0f, 3.0f, 0.0f});
  bench.opacity = 0.03f;
  for (int i = 0; i < 9; ++i) bench.sheets.push_back(0.5f + 0.25f * static_cast<float>(i));
  bench.surfaces = bench.most_surfaces = 3;
  const double passes = std::pow(0.97, 9);
  CHECK(bench.seen() == Approx(passes + (1.0 - passes) * 3.0));
}

TEST_CASE("glass: what lies behind a blended surface takes nothing of its light") {
  Bench bench;
  bench.ior = 1.0f;
  bench.hidden = filled(1, 1, {3.0f, 3.0f, 3.0f, 0.0f});
  bench.tops = {8.0f, 3.0f};
  bench.sheets = {5.0f};
  bench.absorption = 0.3f;
  CHECK(bench.seen() == Approx(std::exp(-0.3) * (0.25 * 3.0 + 0.75 * std::exp(-0.3))));
}

TEST_CASE("glass: behind glass what lets a share through scatters the rest") {
  Bench bench;
  bench.ior = 1.0f;
  bench.hidden = filled(1, 1, {3.0f, 3.0f, 3.0f, 0.0f});
  bench.tops = {8.0f, 3.0f};
  bench.transmitted = 0.5f;
  // What the first scatters is a layer of the picture's.
  CHECK(bench.seen() == Approx(0.5 * (0.5 + 0.5 * 3.0)));
}

TEST_CASE("glass: what hidden rays have found holds the share of blended surfaces, or else none of them") {
  Bench bench;
  bench.ior = 1.0f;
  bench.sheets = {2.0f};
  CHECK(bench.seen() == Approx(1.0));
  bench.in_picture = false;
  bench.hidden = filled(1, 1, {3.0f, 3.0f, 3.0f, 0.0f});
  CHECK(bench.seen() == Approx(3.0));
}

TEST_CASE("glass: the last surfaces are passed straight on") {
  // R = (9 / 11)^2 = 0.669421, more than half: within the plate the mirrored way is the stronger.
  Bench bench;
  bench.ior = 10.0f;
  bench.surfaces = 0;
  CHECK(bench.seen() == Approx(0.330579 * 1.0 + 0.669421 * 0.5));
  // What comes through the second surface has enough to be followed to the floor, too.
  bench.surfaces = 8;
  CHECK(bench.seen() == Approx(0.5 + 0.330579 * 0.330579 * 0.5));
}

// The pixel is 8 m wide. Its rays go .0625 and .1875 of that to either side of x = -2.5: to -2 and -3, then
// to -1 and -4.
TEST_CASE("glass: two rays that bring the same are enough, of four that differ there is the mean") {
  Bench bench;
  bench.several_rays = true;
  CHECK(bench.seen() == Approx(behind_surfaces(1.0, 2)));
  bench.ior = 1.0f;
  bench.at = {-2.5f, -2.0f};
  const auto lit = [&](float from, float to) {
    bench.shown = Image(Format::RGBA32F, 64, 1);
    for (int texel = 0; texel < 64; ++texel) {
      const float x = -4.0f + (static_cast<float>(texel) + 0.5f) / 8.0f;
      for (int c = 0; c < 4; ++c) bench.shown.at(texel, 0, c) = x > from && x < to ? 1.0f : 0.0f;
    }
    return bench.seen();
  };
  CHECK(lit(-9.0f, -2.5f) == Approx(0.5));
  CHECK(lit(-2.5f, -1.5f) == Approx(0.25));
  CHECK(lit(-9.0f, -1.5f) == Approx(1.0));
  CHECK(lit(-9.0f, -3.5f) == 0.0f);
}

TEST_CASE(
    "glass: what the picture does not show has its own colour, and what fades there shows the sky behind "
    "it") {
  Bench bench;
  bench.in_picture = false;
  CHECK(bench.seen() == Approx(0.5));
  // Three quarters of a surface whose radiance is 2.
  bench.hidden = filled(1, 1, {1.5f, 1.5f, 1.5f, 0.25f});
  CHECK(bench.seen() == Approx(behind_surfaces(1.5 + 0.25 * 0.5, 2)));
}

TEST_CASE(
    "glass: what the picture does not show is taken from the nearest four that hold it, not from beside") {
  // The pixel's own is the lower left one; each of nine in turn holds a radiance of 2, alone.
  Bench bench;
  bench.in_picture = false;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) {
      INFO("texel " << x << ", " << y);
      bench.hidden = filled(3, 3, {0.0f, 0.0f, 0.0f, 1.0f});
      for (int c = 0; c < 4; ++c) bench.hidden.at(x, y, c) = c < 3 ? 2.0f : 0.0f;
      CHECK(bench.seen() == Approx(x < 2 && y < 2 ? behind_surfaces(2.0, 2) : 0.5));
    }
}

TEST_CASE("glass: a rough plate shows the mean of what lies behind it") {
  Bench bench;
  bench.at = {-2.5f, -2.0f};
  // A stripe of half a metre under the pixel's middle, on a picture 8 m wide.
  bench.shown = Image(Format::RGBA32F, 64, 1);
  for (int texel = 0; texel < 64; ++texel) {
    const float x = -4.0f + (static_cast<float>(texel) + 0.5f) / 8.0f;
    for (int c = 0; c < 4; ++c) bench.shown.at(texel, 0, c) = std::abs(x + 2.5f) < 0.25f ? 1.0f : 0.0f;
  }
  const float sharp = bench.seen();
  CHECK(sharp == Approx(behind_surfaces(1.0, 2)));
  bench.roughness = 0.6f;
  const float rough = bench.seen();
  CHECK(rough < 0.75f * sharp);
  CHECK(rough > 0.1f * sharp);
  bench.shown = filled(1, 1, glm::vec4(1.0f));
  CHECK(bench.seen() == Approx(sharp));
}

TEST_CASE("glass: rough walls bend nothing, mirror 2 R / (1 + R), and each tints") {
  Bench bench;
  bench.roughness = 0.5f;
  bench.thin = true;
  bench.tint = 0.4f;
  // The plate's two faces are two walls; what the second mirrors brings the sky.
  const double mirrored = 2.0 * 0.04 / 1.04, left = 0.4 * (1.0 - mirrored);
  CHECK(bench.seen() == Approx(mirrored * 0.5 + left * (left + mirrored * 0.5)));
}

TEST_CASE("glass: a pane that is there in part mirrors and tints by its coverage") {
  // Two walls, of which each mirrors 0.25 of 2 R / (1 + R), R = 0.04, of the sky's 0.5.
  Bench bench;
  bench.thin = true;
  bench.covers = 0.25f;
  bench.tint = 0.5f;
  const double mirrored = 0.25 * 0.08 / 1.04, passed = 0.75 + 0.5 * (0.25 - mirrored);
  CHECK(bench.seen() == Approx(mirrored * 0.5 + passed * (mirrored * 0.5 + passed)));
}

TEST_CASE("glass: the strongest of the weaker ways is followed, where it has a tenth or more") {
  // Two walls of R = 0.08 / 1.04. What the second mirrors goes up through the first, from below, and there
  // brings the sky's 0.5 by both ways.
  Bench bench;
  bench.thin = true;
  bench.tint = 0.95f;
  const double r = 0.08 / 1.04, left = (1.0 - r) * 0.95;
  const double mirrored = left * 0.5 + r * 0.5;
  CHECK(bench.seen() == Approx(r * 0.5 + left * (left + r * mirrored)));
  // Of darker glass, by which 3 x 0.3 (1 - r) r = 0.064 would come, it brings the sky.
  bench.tint = 0.3f;
  const double dark = (1.0 - r) * 0.3;
  CHECK(bench.seen() == Approx(r * 0.5 + dark * (dark + r * 0.5)));
}

TEST_CASE("glass: a pane mirrors all around and lights by its coverage, and lets its share through") {
  // Two walls over nothing, of which each mirrors r of the sky's 0.5.
  Bench bench;
  bench.thin = true;
  bench.floor = false;
  bench.backdrop = 0.0f;
  bench.transmitted = 0.3f;
  const auto expected = [](double covers, double highlight) {
    const double r = covers * 0.08 / 1.04, left = 1.0 - covers + 0.3 * (covers - r);
    return covers * highlight + r * 0.5 + left * r * 0.5;
  };
  CHECK(bench.seen() == Approx(expected(1.0, 0.0)));
  bench.highlight = 3.0f;
  CHECK(bench.seen() == Approx(expected(1.0, 3.0)));
  bench.covers = 0.25f;
  CHECK(bench.seen() == Approx(expected(0.25, 3.0)));
}

TEST_CASE("glass: panes are none of the surfaces after which rays go straight on") {
  // Behind 12 walls, of which each leaves a part of what it does not mirror.
  Bench bench;
  bench.thin = true;
  bench.tint = 0.4f;
  bench.tops = {9.5f, 8.0f, 6.5f, 5.0f, 3.5f, 2.0f};
  bench.surfaces = 2;
  bench.most_surfaces = 6;
  const double r = 0.08 / 1.04, left = 0.4 * (1.0 - r);
  double expected = 1.0;
  for (int wall = 0; wall < 12; ++wall) expected = r * 0.5 + left * expected;
  CHECK(bench.seen() == Approx(expected));
}

TEST_CASE("glass: a light's mirror image adds to what glass shows") {
  Bench bench;
  bench.highlight = 3.0f;
  CHECK(bench.seen() == Approx(behind_surfaces(1.0, 2) + 3.0));
}

TEST_CASE("glass: the body that the camera is in absorbs up to what the picture shows") {
  Bench bench;
  bench.absorption = 0.1f;
  bench.glass_in_picture = false;
  CHECK(bench.seen() == Approx(1.0));
  bench.eye_in_glass = true;
  // The camera stands 10 m above the floor, over (0, 0).
  CHECK(bench.seen() == Approx(std::exp(-0.1 * std::sqrt(100.0 + 0.25 + 0.0625))));
}
