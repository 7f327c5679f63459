#include "passes/cells/cells.hpp"

#include <functional>

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A grid of 6 x 6 landings on a floor at height 0, seen from 10 m above through a window of 8 x 8 m, with a
// caustic map of 8 texels a side: a texel is 1 m, and (x, z) lies at (x + 4, 4 - z).
struct Bench {
  std::function<glm::vec4(int, int)> landing = [](int x, int y) {
    return glm::vec4(0.5f * x - 1.25f, 0.0f, 1.25f - 0.5f * y, 1.0f);
  };
  std::function<float(int, int)> material = [](int, int) { return 0.0f; };
  std::function<float(float)> floor_height = [](float) { return 0.0f; };
  float largest = CellLimits{}.largest_share * 8.0f;
  // Of light that was followed from surface to surface: what it has met, and how far its neighbours along the
  // grid's rows (xy) and columns (zw) are to be expected, texels.
  bool walked = false;
  std::function<float(int, int)> path = [](int, int) { return 5.0f; };
  glm::vec4 expected{0.5f, 0.0f, 0.0f, 0.5f};

  PassImages run() const {
    const std140::View seen = shader_view(down(4.0, 10.0, 20.0));
    const CellLimits limits;
    const std140::Cells u{.receiver = seen,
                          .caustic = seen,
                          .jump = limits.jump,
                          .smallest_jump = limits.smallest_jump,
                          .expected = limits.expected,
                          .largest = largest,
                          .gap = limits.gap,
                          .tile_width = 0.0f,
                          .tile_height = 0.0f,
                          .grid_tile = 0.0f,
                          .grid_guard = 0.0f,
                          .grid_side = 6,
                          .map_side = 8};
    Image places(Format::RGBA32F, 6, 6), normals(Format::RGBA32F, 6, 6), floor(Format::RGBA32F, 64, 64);
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 6; ++x) {
        for (int c = 0; c < 4; ++c) places.at(x, y, c) = landing(x, y)[c];
        normals.at(x, y, 3) = material(x, y);
      }
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const float px = -4.0f + (static_cast<float>(x) + 0.5f) / 8.0f;
        const float texel[4] = {px, floor_height(px), 4.0f - (static_cast<float>(y) + 0.5f) / 8.0f, 1.0f};
        for (int c = 0; c < 4; ++c) floor.at(x, y, c) = texel[c];
      }
    std::vector<Image> textures{places, filled(6, 6, {4.0f, 8.0f, 12.0f, 0.0f}), normals, floor};
    if (walked) {
      Image paths(Format::RGBA32F, 6, 6);
      for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 6; ++x) paths.at(x, y, 0) = path(x, y);
      textures.insert(textures.end(), {paths, filled(6, 6, expected * 0.125f)});
    }
    return run_pass(
        walked ? definition_with(cells_pass(), &Effects::further_surfaces) : definition_of(cells_pass()),
        {.width = 6, .height = 6, .uniforms = uniform_bytes(u), .textures = textures});
  }

  // Which cells of row y are whole: "11111" for all five.
  std::string row(int y) const {
    const PassImages out = run();
    std::string text;
    for (int x = 0; x < 6; ++x) text += out["cell_flux"].at(x, y, 3) == 1.0f ? '1' : '0';
    return text;
  }
};

}  // namespace

TEST_CASE("cells: neighbouring landings are a cell with a quarter of each one's flux") {
  const PassImages out = Bench{}.run();
  CHECK(texel(out["cell_flux"], 2, 2) == glm::vec4(4.0f, 8.0f, 12.0f, 1.0f));
  // Grid vertex (2, 2) lands at (-0.25, 0.25): texel (3.75, 3.75).
  CHECK(texel(out["cell_near"], 2, 2) == glm::vec4(3.75f, 3.75f, 4.25f, 3.75f));
  CHECK(texel(out["cell_far"], 2, 2) == glm::vec4(3.75f, 4.25f, 4.25f, 4.25f));
}

TEST_CASE("cells: the last column and row begin no cell") {
  CHECK(Bench{}.row(2) == "111110");
  CHECK(Bench{}.row(5) == "000000");
}

TEST_CASE("cells: a landing that is none breaks the four cells around it") {
  Bench bench;
  bench.landing = [](int x, int y) {
    return glm::vec4(0.5f * x - 1.25f, 0.0f, 1.25f - 0.5f * y, x == 3 && y == 2 ? 4.0f : 1.0f);
  };
  CHECK(bench.row(0) == "111110");
  CHECK(bench.row(1) == "110010");
  CHECK(bench.row(2) == "110010");
  CHECK(bench.row(3) == "111110");
  // Whatever has become of its light.
  for (const float status : {0.0f, 2.0f, 3.0f, 5.0f, 6.0f}) {
    bench.landing = [=](int x, int y) {
      return glm::vec4(0.5f * x - 1.25f, 0.0f, 1.25f - 0.5f * y, x == 3 && y == 2 ? status : 1.0f);
    };
    CHECK(bench.row(1) == "110010");
  }
}

TEST_CASE("cells: no cell spans two materials") {
  Bench bench;
  bench.material = [](int x, int) { return x < 3 ? 0.0f : 1.0f; };
  CHECK(bench.row(2) == "110110");
}

TEST_CASE("cells: where the spacing leaps there is no cell") {
  // Two bundles of five times the spacing 0.5 m, 2.5 m apart: five times as far and more than 2 texels.
  Bench bench;
  bench.landing = [](int x, int y) {
    return glm::vec4(0.5f * x - 3.0f + (x < 3 ? 0.0f : 2.0f), 0.0f, 1.25f - 0.5f * y, 1.0f);
  };
  CHECK(bench.row(2) == "110110");
}

TEST_CASE("cells: no cell spans the levels of a step") {
  // A step of 3 m half way between columns 2 and 3, at x = 0; landings on both levels.
  Bench bench;
  bench.floor_height = [](float x) { return x < 0.0f ? 0.0f : 3.0f; };
  bench.landing = [](int x, int y) {
    return glm::vec4(0.5f * x - 1.25f, x < 3 ? 0.0f : 3.0f, 1.25f - 0.5f * y, 1.0f);
  };
  CHECK(bench.row(2) == "110110");
}

TEST_CASE("cells: a slope as high as that step is one surface") {
  Bench bench;
  bench.floor_height = [](float x) { return 1.2f * x; };
  bench.landing = [](int x, int y) {
    const float px = 0.5f * static_cast<float>(x) - 1.25f;
    return glm::vec4(px, 1.2f * px, 1.25f - 0.5f * static_cast<float>(y), 1.0f);
  };
  CHECK(bench.row(2) == "111110");
}

TEST_CASE("cells: light that was followed is one cell where all four met the same, whatever they began on") {
  Bench bench;
  bench.walked = true;
  bench.material = [](int x, int) { return x < 3 ? 0.0f : 1.0f; };
  CHECK(bench.row(2) == "111110");
  bench.path = [](int x, int) { return x < 3 ? 5.0f : 6.0f; };
  CHECK(bench.row(2) == "110110");
  bench.path = [](int x, int y) { return x == 3 && y == 2 ? 6.0f : 5.0f; };
  CHECK(bench.row(1) == "110010");
  CHECK(bench.row(2) == "110010");
  CHECK(bench.row(3) == "111110");
}

TEST_CASE("cells: light that was followed is one cell where landings lie as their differentials expect") {
  // Two bundles are 3 m apart, so 2.5 texels more than they expect; 2 texels and half of the 0.5 are allowed.
  const auto apart = [](bool along_rows) {
    Bench bench;
    bench.walked = true;
    bench.largest = 8.0f;
    bench.landing = [=](int x, int y) {
      const float gap_x = along_rows && x > 2 ? 2.5f : 0.0f, gap_y = !along_rows && y > 2 ? 2.5f : 0.0f;
      return glm::vec4(0.5f * x - 3.0f + gap_x, 0.0f, 3.0f - 0.5f * y - gap_y, 1.0f);
    };
    return bench;
  };
  Bench rows = apart(true), columns = apart(false);
  CHECK(rows.row(2) == "110110");
  CHECK(columns.row(1) == "111110");
  CHECK(columns.row(2) == "000000");
  // If they expect 1 texel it is 2 more, and 2 + 1/2 are allowed.
  rows.expected = {1.0f, 0.0f, 0.0f, 0.5f};
  CHECK(rows.row(2) == "111110");
  columns.expected = {0.5f, 0.0f, 0.0f, 1.0f};
  CHECK(columns.row(2) == "111110");
  // Where they expect each other the other way round the bundles are apart again.
  rows.expected = {-1.0f, 0.0f, 0.0f, 0.5f};
  CHECK(rows.row(2) == "110110");
}

TEST_CASE("cells: a landing may be half its differential off the place which both expect, and 2 texels") {
  // The bundles are 1.5 m, 1.5 texels, and `gap` apart along x where 1.5 texels are expected: 2.75 are
  // allowed.
  Bench bench;
  bench.walked = true;
  bench.largest = 8.0f;
  bench.expected = {1.5f, 0.0f, 0.0f, 0.5f};
  for (const float gap : {2.7f, 2.8f}) {
    bench.landing = [=](int x, int y) {
      return glm::vec4(0.5f * x - 3.0f + (x < 3 ? 0.0f : 1.0f + gap), 0.0f, 1.25f - 0.5f * y, 1.0f);
    };
    CHECK(bench.row(2) == (gap < 2.75f ? "111110" : "110110"));
  }
}

TEST_CASE("cells: light that was followed makes no cell larger than a part of the map") {
  // The bundles are 3 texels apart, as they expect; a cell may span 2.
  Bench bench;
  bench.walked = true;
  bench.expected = {3.0f, 0.0f, 0.0f, 0.5f};
  bench.landing = [](int x, int y) {
    return glm::vec4(0.5f * x - 3.0f + (x < 3 ? 0.0f : 2.5f), 0.0f, 1.25f - 0.5f * y, 1.0f);
  };
  CHECK(bench.row(2) == "110110");
}
