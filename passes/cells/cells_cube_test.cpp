// Cells of a light that sees all around, whose grid and map are a cube's six faces.
#include <algorithm>
#include <cmath>

#include "passes/cells/cells.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// The light stands in the middle of a cube of side 2, and nothing bends its light: a face has 10 x 10 grid
// vertices, its outermost 0.9 from the middle, and 20 x 36 texels of the map, with 6 around it.
constexpr CubeAtlas kGrid{.side = 48, .guard = 3, .square = true};
constexpr int kMap = 96, kGuard = 6;

// Where the ray of a texel's middle meets a cube of so many times the side.
glm::vec4 on_cube(const CubeAtlas& atlas, int x, int y, float size) {
  const int face = std::min(3 * (y / atlas.tile_height()) + x / atlas.tile_width(), 5);
  const glm::dvec2 extent(atlas.face_width(), atlas.face_height());
  const glm::dvec2 tangents = (glm::dvec2(x + 0.5, y + 0.5) - atlas.texel(glm::dvec2(-1.0), face)) / extent;
  const glm::dvec3 q = turned_from_face(glm::dvec3(2.0 * tangents - 1.0, 1.0), face);
  const glm::dvec3 size_of = glm::abs(q);
  return {glm::vec3(q / std::max({size_of.x, size_of.y, size_of.z})) * size, 1.0f};
}

struct CubeBench {
  float walls = 1.0f;      // where the receivers are, of where light lands
  glm::ivec2 missing{-1};  // a grid vertex whose light lands nowhere

  PassImages run() const {
    View light;
    light.right = {1, 0, 0};
    light.up = {0, 1, 0};
    light.forward = {0, 0, 1};
    light.perspective = true;
    light.near = 0.1;
    light.far = 4.0;
    light.cube = CubeAtlas{.side = kMap, .guard = kGuard};
    const CellLimits limits;
    const std140::Cells u{.receiver = shader_view(light),
                          .caustic = shader_view(light),
                          .jump = limits.jump,
                          .smallest_jump = limits.smallest_jump,
                          .expected = limits.expected,
                          .largest = limits.largest_share * kMap,
                          .gap = limits.gap,
                          .tile_width = static_cast<float>(light.cube->tile_width()),
                          .tile_height = static_cast<float>(light.cube->tile_height()),
                          .grid_tile = static_cast<float>(kGrid.tile_width()),
                          .grid_guard = static_cast<float>(kGrid.guard),
                          .grid_side = kGrid.side,
                          .map_side = kMap};
    Image places(Format::RGBA32F, kGrid.side, kGrid.side), receivers(Format::RGBA32F, kMap, kMap);
    const auto fill = [](Image& image, const CubeAtlas& atlas, float size) {
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          for (int c = 0; c < 4; ++c) image.at(x, y, c) = on_cube(atlas, x, y, size)[c];
    };
    fill(places, kGrid, 1.0f);
    fill(receivers, *light.cube, walls);
    if (missing.x >= 0) places.at(missing.x, missing.y, 3) = 4.0f;
    const Image flux = filled(kGrid.side, kGrid.side, {4.0f, 8.0f, 12.0f, 0.0f});
    return run_pass(definition_of(cells_pass()),
                    {.width = kGrid.side,
                     .height = kGrid.side,
                     .uniforms = uniform_bytes(u),
                     .textures = {places, flux, filled(kGrid.side, kGrid.side, glm::vec4(0.0f)), receivers}});
  }
};

// The square of the last vertex along both axes of the face that looks along z: tile (1, 1) from 16 on.
constexpr int kLast = 16 + 3 + 9;

void check_texel(const glm::vec4& found, const glm::vec4& expected) {
  for (int c = 0; c < 4; ++c) CHECK(found[c] == Approx(expected[c]).epsilon(1e-4));
}

}  // namespace

TEST_CASE("cells: at a cube's corner three faces' vertices are half a cell") {
  const PassImages out = CubeBench{}.run();
  // The face's texels begin at (32 + 6, 48 + 6). Its own vertex is (0.9, 0.9, 1); beyond its edges it goes on
  // with (1, 0.9, 0.9) and (0.9, 1, 0.9), as seen in it at (10/9, 1) and (1, 10/9).
  check_texel(texel(out["cell_near"], kLast, kLast), {38 + 19.0 / 0.9, 54 + 36, 38 + 19, 54 + 34.2});
  check_texel(texel(out["cell_far"], kLast, kLast),
              {38 + (19.0 / 0.9 + 20.0) / 2.0, 54 + (36.0 + 34.2 / 0.9) / 2.0, 38 + 20, 54 + 34.2 / 0.9});
  CHECK(texel(out["cell_flux"], kLast, kLast) == glm::vec4(2.0f, 4.0f, 6.0f, 0.5f));
  // So it is at the eight corners, on each of the three faces.
  int halves = 0;
  for (int y = 0; y < kGrid.side; ++y)
    for (int x = 0; x < kGrid.side; ++x) halves += out["cell_flux"].at(x, y, 3) == 0.5f;
  CHECK(halves == 24);
}

TEST_CASE("cells: a cube's corner is none where light lands nowhere, or no surface joins where it lands") {
  CubeBench bench;
  bench.missing = {kLast, kLast};
  CHECK(bench.run()["cell_flux"].at(kLast, kLast, 3) == 0.0f);
  bench.missing = glm::ivec2(-1);
  bench.walls = 2.0f;
  CHECK(bench.run()["cell_flux"].at(kLast, kLast, 3) == 0.0f);
}
