#include "passes/cascade_cells/cascade_cells.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Lays one cell with corners a, b, c, d (texels of the caustic map) and flux (1, 2, 4) into a cascade of 8 x
// 8 texels that shows the caustic map's texels 2 to 6: one texel there is two by two here.
Image lay(glm::vec2 a, glm::vec2 b, glm::vec2 c, glm::vec2 d) {
  const std140::CascadeCells uniforms{
      .scale = {2.0f, 2.0f}, .offset = {-4.0f, -4.0f}, .cells_a_side = 1, .map_side = 8};
  return run_pass(
      definition_with(cascade_cells_pass(), &Effects::coloured_caustics),
      {.width = 8,
       .height = 8,
       .uniforms = uniform_bytes(uniforms),
       .textures = {filled(1, 1, {a, b}), filled(1, 1, {c, d}), filled(1, 1, {1.0f, 2.0f, 4.0f, 1.0f})},
       .vertex_count = 6})["caustic_map"];
}

}  // namespace

TEST_CASE("cascade_cells: a texel of the caustic map is shared by those inside it") {
  const Image map = lay({3, 4}, {4, 4}, {3, 5}, {4, 5});
  for (const int y : {4, 5})
    for (const int x : {2, 3}) CHECK(texel(map, x, y) == glm::vec4(0.25f, 0.5f, 1.0f, 0.25f));
  CHECK(sum(map) == 1.0);
}

TEST_CASE("cascade_cells: a cell is cut at the cascade's edge") {
  // From 1 to 4 in x and 2 to 3 in y, of which 2 to 4 are shown: two thirds of the light, even over 4 x 2
  // texels.
  const Image map = lay({1, 2}, {4, 2}, {1, 3}, {4, 3});
  for (int x = 0; x < 4; ++x) CHECK(map.at(x, 1, 0) == Approx(1.0 / 12.0));
  CHECK(map.at(4, 0, 0) == 0.0f);
  CHECK(sum(map) == Approx(2.0 / 3.0));
}

TEST_CASE("cascade_cells: a cell larger than the cascade fills it evenly") {
  // 1000 x 1000 texels of the caustic map, of which 4 x 4 are shown.
  const Image map = lay({-500, -500}, {500, -500}, {-500, 500}, {500, 500});
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) CHECK(map.at(x, y, 0) == Approx(1.6e-5 / 64.0).epsilon(0.05));
}

TEST_CASE("cascade_cells: a cell beside the cascade leaves it empty") {
  CHECK(sum(lay({0, 0}, {1, 0}, {0, 1}, {1, 1})) == 0.0);
  CHECK(sum(lay({6.5f, 3}, {7, 3}, {6.5f, 4}, {7, 4})) == 0.0);
}
